// Where the value of an option is stored, and the conversions between its word and its value.
#pragma once

#include "apps/options/option.h"
#include "apps/options/values.h"

#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace lambent::cli {

/// Parses a number. Throws Error(usage) if it is not in the option's domain.
double number_of(const Option& option, const std::string& word);

/// The index of a word among the choices. Throws Error(usage), with a suggestion, for any other word.
std::size_t choice_of(const Option& option, const std::string& word);

/// The shortest word, of at least six digits, that reads back as the same number; for an angle, degrees of the radians
/// in the float. A number below the domain gives the domain's word for it, if any, else an empty word: not set.
std::string word_of_number(const Option& option, double value);
std::string word_of_number(const Option& option, float value);

/// Of an option with two values, the word that is not the default; "yes" for a flag.
std::string other_word(const Option& option);

template <class T>
concept Sized = requires(T value)
{
    value.width;
    value.height;
};

template <class T>
concept Optional = requires(T value)
{
    value.has_value();
};

template <class T>
void read_value(const Option& option, const std::string& word, T& value)
{
    if constexpr (Optional<T>)
        read_value(option, word, value.emplace());
    else if constexpr (std::is_enum_v<T>)
        value = static_cast<T>(choice_of(option, word));
    else if constexpr (std::same_as<T, float>)
        value = option.domain.kind == Domain::Kind::angle ? turned(number_of(option, word))
                                                          : static_cast<float>(number_of(option, word));
    else if constexpr (std::is_arithmetic_v<T>)
        value = static_cast<T>(number_of(option, word));
    else if constexpr (std::same_as<T, glm::vec3>)
        value = parse_color(word, dashed(option));
    else if constexpr (std::same_as<T, glm::dvec3>)
        value = parse_point(word, dashed(option));
    else if constexpr (std::same_as<T, view::Orbit>)
        value = parse_orbit(word, dashed(option));
    else if constexpr (std::same_as<T, draw::Background>)
        value = parse_background(word, dashed(option));
    else
        value = word;
}

template <class T>
std::string word_of(const Option& option, const T& value)
{
    if constexpr (Optional<T>)
        return value ? word_of(option, *value) : std::string();
    else if constexpr (std::is_enum_v<T>)
        return words_in(option.domain.choices).at(static_cast<std::size_t>(value));
    else if constexpr (std::same_as<T, float>)
        return word_of_number(option, value);
    else if constexpr (std::is_arithmetic_v<T>)
        return word_of_number(option, static_cast<double>(value));
    else if constexpr (std::same_as<T, std::string>)
        return value;
    else
        return value_word(value);
}

/// Sets and reads an option's value in the arguments of a command. An empty word restores the default; each word of an
/// option that may be repeated adds a value.
template <class Arguments>
struct Value {
    void (*set)(Arguments& arguments, const Option& option,
                const std::string& word) = nullptr; ///< throws Error(usage)
    std::string (*get)(const Arguments& arguments, const Option& option) = nullptr;

    constexpr Value() = default;
    constexpr Value(decltype(set) setter, decltype(get) getter) : set(setter), get(getter) {}

    /// For the member to which a lambda returns a reference.
    template <class At>
    requires std::is_empty_v<At>
    constexpr Value(At) : set(&set_at<At>), get(&get_at<At>) {}

private:
    template <class At>
    static void set_at(Arguments& arguments, const Option& option, const std::string& word)
    {
        const Arguments usual;
        auto& value = At()(arguments);
        const auto& usual_value = At()(usual);
        using T = std::remove_reference_t<decltype(value)>;
        if constexpr (Sized<T>) {
            const Size size =
                word.empty() ? Size{usual_value.width, usual_value.height} : parse_size(word, dashed(option));
            value.width = size.width;
            value.height = size.height;
        } else if constexpr (std::same_as<T, bool>) {
            if (option.domain.kind == Domain::Kind::choice && !word.empty())
                choice_of(option, word);
            value = (word.empty() || word == option.usual) == usual_value;
        } else if (word.empty()) {
            value = usual_value;
        } else {
            read_value(option, word, value);
        }
    }

    template <class At>
    static std::string get_at(const Arguments& arguments, const Option& option)
    {
        const auto& value = At()(arguments);
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (Sized<T>) {
            return size_word({value.width, value.height});
        } else if constexpr (std::same_as<T, bool>) {
            const Arguments usual;
            return value == At()(usual) ? std::string(option.usual) : other_word(option);
        } else {
            return word_of(option, value);
        }
    }
};

/// A row of the table: an option and where its value is stored. Each further property is set by one call.
template <class Arguments>
struct Row {
    Option option;
    Value<Arguments> value;

    /// A flag.
    explicit Row(std::string_view name) : Row(name, {}, flag) {}

    /// `word`: name of the value in the help; `usual`: the default's word, if there is a default.
    Row(std::string_view name, std::string_view word, const Domain& domain, std::string_view usual = {})
        : option{name, word, domain, usual}
    {
    }

    Row& at(Value<Arguments> where) { return value = where, *this; }
    Row& says(std::string_view help, std::string_view manual = {})
    {
        return option.help = help, option.manual = manual, *this;
    }
    Row& usually(std::string_view said) { return option.usually = said, *this; }
    Row& form(Form form, char letter = 0) { return option.form = form, option.letter = letter, *this; }
    Row& only(Needs needs) { return option.needs = needs, *this; }
    Row& place(int place) { return option.place = place, *this; }
    Row& control(int place, const Control& how) { return option.place = place, option.control = how, *this; }
};

/// Rows under one heading in the help of the same commands.
template <class Arguments>
struct Group {
    std::string_view heading;
    unsigned commands = 0;
    std::vector<Row<Arguments>> rows;
};

} // namespace lambent::cli
