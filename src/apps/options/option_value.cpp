#include "apps/options/option_value.h"

#include "base/closest.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace lambent::cli {
namespace {

[[noreturn]] void refuse_number(const Option& option, const std::string& word, const std::string& why)
{
    throw Error(Failure::usage, text(dashed(option), ": ", word, " is not ", why));
}

} // namespace

std::string dashed(const Option& option)
{
    return text("--", option.name);
}

std::string_view default_of(const Option& option)
{
    return option.usually.empty() ? option.usual : option.usually;
}

std::string help_of(const Option& option)
{
    const std::string_view usual = default_of(option);
    return usual.empty() ? std::string(option.help) : text(option.help, " (", usual, ")");
}

std::vector<std::string> words_in(std::string_view choices)
{
    std::istringstream stream{std::string(choices)};
    return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

double number_of(const Option& option, const std::string& word)
{
    const Domain& domain = option.domain;
    const bool is_whole = domain.kind == Domain::Kind::whole;
    if (is_whole && !domain.choices.empty() && word == domain.choices)
        return domain.least - 1.0;
    const double value = parse_number(word, dashed(option));
    const bool is_in = value >= domain.least && value <= domain.most;
    if (is_whole && !(is_in && value == std::floor(value)))
        refuse_number(option, word,
                      text("a whole number from ", static_cast<long>(domain.least), " to ",
                           static_cast<long>(domain.most)));
    // Compared as floats, because a positive double may become 0 as a float.
    if (domain.above_least && !(static_cast<float>(value) > static_cast<float>(domain.least)))
        refuse_number(option, word, text("above ", domain.least));
    if (!is_in && domain.most >= any_number.most)
        throw Error(Failure::usage, text(dashed(option), ": ", word, " is below ", domain.least));
    if (!is_in)
        refuse_number(option, word, text("from ", domain.least, " to ", domain.most));
    return value;
}

std::size_t choice_of(const Option& option, const std::string& word)
{
    const std::vector<std::string> known = words_in(option.domain.choices);
    const auto found = std::find(known.begin(), known.end(), word);
    if (found != known.end())
        return static_cast<std::size_t>(found - known.begin());
    std::string all;
    for (const std::string& one : known)
        all += text(all.empty() ? "" : ", ", one);
    throw Error(Failure::usage,
                text(dashed(option), ": '", word, "' is none of ", all, did_you_mean(word, known)));
}

std::string word_of_number(const Option& option, double value)
{
    return value < option.domain.least ? std::string(option.domain.choices) : exact_word(value);
}

std::string word_of_number(const Option& option, float value)
{
    if (option.domain.kind == Domain::Kind::angle)
        return degrees_word(value);
    return exact_word(value);
}

std::string other_word(const Option& option)
{
    for (const std::string& word : words_in(option.domain.choices))
        if (word != option.usual)
            return word;
    return "yes";
}

} // namespace lambent::cli
