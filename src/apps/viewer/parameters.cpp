#include "apps/viewer/parameters.h"

#include "apps/options/values.h"
#include "base/error.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace lambent::viewer {
namespace {

// Above these a picture takes many minutes.
constexpr double most_samples = 1024.0, most_edge_samples = 16.0;

constexpr std::array table = {
    Parameter{"exposure", "Exposure", "Display", Kind::number, "1", least_exposure, most_exposure, true},
    Parameter{"contrast", "Contrast", "Display", Kind::number, "1", 0.05, 20.0, true},
    Parameter{"tone", "Tone curve", "Display", Kind::choice, "reinhard", 0, 0, false,
              "reinhard neutral aces agx linear"},
    Parameter{"space", "Space", "Display", Kind::choice, "linear", 0, 0, false, "linear nonlinear"},
    Parameter{"layer", "Show", "Display", Kind::choice, "picture", 0, 0, false,
              "picture reference error base_color specular alpha roughness metalness normal depth occlusion "
              "mip_level irradiance light_emitted light_direct light_ambient light_specular background"},
    Parameter{"bounces", "Reference bounces", "Display", Kind::whole, "8", 0.0, 64.0},
    Parameter{"env-rotation", "Rotation", "Light", Kind::number, "0", -180.0, 180.0},
    Parameter{"ambient-brightness", "Diffuse brightness", "Light", Kind::number, "1", 0.0, 20.0},
    Parameter{"ibl", "Specular light", "Light", Kind::choice, "sampled", 0, 0, false, "sampled split-sum"},
    Parameter{"samples", "Samples", "Light", Kind::whole, "40", 1.0, most_samples, true},
    Parameter{"background", "Background", "Light", Kind::choice, "env", 0, 0, false,
              "env none blur:0.2 blur:0.4 blur:0.7 0,0,0 0.2,0.2,0.2 1,1,1"},
    Parameter{"model", "Model", "Surfaces", Kind::choice, "ggx", 0, 0, false, "ggx phong"},
    Parameter{"roughness", "Roughness", "Surfaces", Kind::number, "", 0.0, 1.0, false, {}, Scope::ggx},
    Parameter{"mip-level", "Mip level", "Surfaces", Kind::choice, "matched", 0, 0, false, "matched report"},
    Parameter{"alpha", "Exponent", "Surfaces", Kind::number, "", 0.01, 1.0e6, true, {}, Scope::phong_shapes},
    Parameter{"kd", "Diffuse colour", "Surfaces", Kind::color, "", 0.0, 1.0, false, {}, Scope::phong_shapes},
    Parameter{"ks", "Specular colour", "Surfaces", Kind::color, "", 0.0, 1.0, false, {}, Scope::phong_shapes},
    Parameter{"fov", "Field of view", "Camera", Kind::number, "45", least_fov, most_fov},
    Parameter{"aa", "Edge samples", "Camera", Kind::whole, "4", 1.0, most_edge_samples},
};

const Parameter& find(std::string_view name)
{
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const Parameter& row) { return row.name == name; });
    if (found == table.end())
        throw Error(Failure::usage, text("there is no parameter '", name.substr(0, 40), "'"));
    return *found;
}

std::vector<std::string> words_of(std::string_view choices)
{
    std::istringstream stream{std::string(choices)};
    return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

void check_range(const Parameter& row, double value)
{
    if (value < row.least || value > row.most)
        throw Error(Failure::usage,
                    text(row.name, ": ", value, " is not from ", row.least, " to ", row.most));
}

std::string checked_choice(const Parameter& row, const std::string& word)
{
    // The list has a few of what there may be.
    if (row.name == "background") {
        cli::parse_background(word, "background");
        return word;
    }
    const std::vector<std::string> words = words_of(row.choices);
    if (std::find(words.begin(), words.end(), word) == words.end())
        throw Error(Failure::usage, text(row.name, ": '", word.substr(0, 40), "' is none of ", row.choices));
    return word;
}

std::string checked_color(const Parameter& row, const std::string& word)
{
    const glm::vec3 color = cli::parse_color(word, std::string(row.name));
    for (int c = 0; c < 3; ++c)
        check_range(row, static_cast<double>(color[c]));
    return text(number_word(static_cast<double>(color.r)), ",", number_word(static_cast<double>(color.g)),
                ",", number_word(static_cast<double>(color.b)));
}

std::string checked_number(const Parameter& row, const std::string& word)
{
    const double value = cli::parse_number(word, std::string(row.name));
    check_range(row, value);
    if (row.kind == Kind::whole && value != std::floor(value))
        throw Error(Failure::usage, text(row.name, ": ", value, " is not a whole number"));
    return number_word(value);
}

std::string checked(const Parameter& row, const std::string& word)
{
    if (word.empty() && row.may_be_empty())
        return word;
    switch (row.kind) {
    case Kind::choice:
        return checked_choice(row, word);
    case Kind::color:
        return checked_color(row, word);
    default:
        return checked_number(row, word);
    }
}

const char* name_of(Kind kind)
{
    constexpr std::array names = {"number", "whole", "choice", "color"};
    return names[static_cast<std::size_t>(kind)];
}

const char* name_of(Scope scope)
{
    constexpr std::array names = {"all", "ggx", "phong_shapes"};
    return names[static_cast<std::size_t>(scope)];
}

} // namespace

std::span<const Parameter> parameters()
{
    return table;
}

Values::Values()
{
    for (const Parameter& row : table)
        words_.emplace(row.name, row.usual);
}

const std::string& Values::operator[](std::string_view name) const
{
    return words_.find(find(name).name)->second;
}

void Values::set(std::string_view name, const std::string& word)
{
    const Parameter& row = find(name);
    words_.find(row.name)->second = checked(row, word);
}

bool Values::applies(const Parameter& row, bool built_in) const
{
    const bool phong = (*this)["model"] == "phong";
    switch (row.scope) {
    case Scope::ggx:
        return !phong;
    case Scope::phong_shapes:
        return phong && built_in;
    default:
        return true;
    }
}

std::vector<std::string> Values::options(bool built_in) const
{
    std::vector<std::string> options;
    for (const Parameter& row : table) {
        const std::string& word = (*this)[row.name];
        if (row.name == "layer" || row.name == "bounces" || word == row.usual || !applies(row, built_in))
            continue;
        options.push_back(text("--", row.name));
        options.push_back(word);
    }
    return options;
}

nlohmann::ordered_json to_json(std::span<const Parameter> rows)
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Parameter& row : rows) {
        nlohmann::ordered_json entry = {{"name", row.name},           {"label", row.label},
                                        {"group", row.group},         {"kind", name_of(row.kind)},
                                        {"usual", row.usual},         {"least", row.least},
                                        {"most", row.most},           {"logarithmic", row.logarithmic},
                                        {"scope", name_of(row.scope)}};
        if (row.kind == Kind::choice)
            entry["choices"] = words_of(row.choices);
        list.push_back(std::move(entry));
    }
    return list;
}

nlohmann::ordered_json to_json(const Values& values)
{
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const Parameter& row : table)
        object[std::string(row.name)] = values[row.name];
    return object;
}

namespace {

std::string word_of_digits(double value, int digits)
{
    char word[32];
    const auto end = std::to_chars(word, word + sizeof word, value, std::chars_format::general, digits).ptr;
    const std::string written(word, end);
    return written == "-0" ? "0" : written;
}

} // namespace

std::string number_word(double value)
{
    return word_of_digits(value, 6);
}

std::string place_word(double value, double scale)
{
    const double more = std::log10(std::fabs(value) / scale);
    return word_of_digits(value, more > 0.0 ? static_cast<int>(std::min(6.0 + std::ceil(more), 15.0)) : 6);
}

} // namespace lambent::viewer
