#include "apps/options/values.h"

#include "base/error.h"
#include "base/text.h"

#include <charconv>
#include <cmath>
#include <numbers>

namespace lambent::cli {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& word, const std::string& wanted)
{
    throw Error(Failure::usage, text(option, ": '", word, "' is not ", wanted));
}

std::vector<std::string> split(const std::string& word, char separator)
{
    std::vector<std::string> parts(1);
    for (const char c : word)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

glm::vec3 vec3_at(const std::vector<double>& numbers, std::size_t first)
{
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

void check_not_negative(const glm::vec3& color, const std::string& word, const std::string& option)
{
    if (color.r < 0.0f || color.g < 0.0f || color.b < 0.0f)
        refuse(option, word, "a colour: a part is negative");
}

// The shortest word, of at least six digits, for which is_same(the number read back) holds.
template <class Same>
std::string shortest(double value, Same is_same)
{
    std::string word;
    for (int digits = 6; digits <= 17; ++digits) {
        word = word_of_digits(value, digits);
        double read = 0.0;
        std::from_chars(word.data(), word.data() + word.size(), read);
        if (is_same(read))
            break;
    }
    return word;
}

} // namespace

float radians(double degrees)
{
    return static_cast<float>(degrees * std::numbers::pi / 180.0);
}

float turned(double degrees)
{
    return radians(std::remainder(degrees, 360.0));
}

std::string word_of_digits(double value, int digits)
{
    char word[32];
    const auto end = std::to_chars(word, word + sizeof word, value, std::chars_format::general, digits).ptr;
    const std::string written(word, end);
    return written == "-0" ? "0" : written;
}

std::string number_word(double value)
{
    return word_of_digits(value, 6);
}

std::string exact_word(double value)
{
    return shortest(value, [&](double read) { return read == value; });
}

std::string exact_word(float value)
{
    return shortest(static_cast<double>(value),
                    [&](double read) { return static_cast<float>(read) == value; });
}

std::string degrees_word(float value)
{
    const double degrees = static_cast<double>(value) * 180.0 / std::numbers::pi;
    return shortest(degrees, [&](double read) { return turned(read) == value; });
}

std::string value_word(const glm::vec3& color)
{
    return text(exact_word(color.r), ",", exact_word(color.g), ",", exact_word(color.b));
}

std::string value_word(const glm::dvec3& point)
{
    return text(exact_word(point.x), ",", exact_word(point.y), ",", exact_word(point.z));
}

std::string value_word(const view::Orbit& orbit)
{
    const std::string angles = text(degrees_word(orbit.azimuth), ",", degrees_word(orbit.elevation));
    return orbit.distance > 0.0f ? text(angles, ",", exact_word(orbit.distance)) : angles;
}

std::string value_word(const draw::Background& background)
{
    using Kind = draw::Background::Kind;
    switch (background.kind) {
    case Kind::environment:
        return "env";
    case Kind::none:
        return "none";
    case Kind::blurred:
        return text("blur:", exact_word(background.roughness));
    default:
        return value_word(background.color);
    }
}

std::string size_word(Size size)
{
    return text(size.width, "x", size.height);
}

double parse_number(const std::string& word, const std::string& option)
{
    double value = 0.0;
    const char* first = word.data();
    const char* const last = first + word.size();
    if (first != last && *first == '+')
        ++first;
    const auto [end, error] = std::from_chars(first, last, value);
    // Most values are stored as floats: larger numbers would become infinite.
    if (error == std::errc::result_out_of_range || (end == last && std::fabs(value) > 3.0e38))
        refuse(option, word, "a number up to 3e38");
    if (error != std::errc() || end != last || !std::isfinite(value))
        refuse(option, word, "a number");
    return value;
}

Size parse_size(const std::string& word, const std::string& option)
{
    const std::vector<std::string> parts = split(word, 'x');
    if (parts.size() != 2)
        refuse(option, word, "a size like 1280x720");
    const auto side = [&](const std::string& part) {
        const double value = parse_number(part, option);
        if (value < 1.0 || value > 65536.0 || value != std::floor(value))
            refuse(option, word, "a size with sides from 1 to 65536");
        return static_cast<int>(value);
    };
    const Size size{side(parts[0]), side(parts[1])};
    if (static_cast<double>(size.width) * size.height > 0x1p28)
        refuse(option, word, "a size of at most 2^28 pixels");
    return size;
}

std::vector<double> parse_list(const std::string& word, Count count, const std::string& option)
{
    std::vector<double> numbers;
    for (const std::string& part : split(word, ','))
        numbers.push_back(parse_number(part, option));
    if (numbers.size() < count.least || numbers.size() > count.most)
        refuse(option, word,
               count.least == count.most ? text(count.least, " numbers between commas")
                                         : text(count.least, " to ", count.most, " numbers between commas"));
    return numbers;
}

glm::vec3 parse_color(const std::string& word, const std::string& option)
{
    const glm::vec3 color = vec3_at(parse_list(word, {3, 3}, option), 0);
    check_not_negative(color, word, option);
    return color;
}

glm::dvec3 parse_point(const std::string& word, const std::string& option)
{
    const std::vector<double> numbers = parse_list(word, {3, 3}, option);
    return {numbers[0], numbers[1], numbers[2]};
}

view::Orbit parse_orbit(const std::string& word, const std::string& option)
{
    const std::vector<double> numbers = parse_list(word, {2, 3}, option);
    if (std::fabs(numbers[1]) > 90.0)
        refuse(option, word, "a camera: the elevation must be from -90 to 90 degrees");
    if (numbers.size() == 3 && numbers[2] <= 0.0)
        refuse(option, word, "a camera: the distance must be above 0");
    return {turned(numbers[0]), radians(numbers[1]),
            numbers.size() == 3 ? static_cast<float>(numbers[2]) : 0.0f};
}

draw::Background parse_background(const std::string& word, const std::string& option)
{
    using Kind = draw::Background::Kind;
    draw::Background background;
    if (word == "env")
        return background;
    if (word == "none") {
        background.kind = Kind::none;
        return background;
    }
    if (word.starts_with("blur:")) {
        background.kind = Kind::blurred;
        background.roughness = static_cast<float>(parse_number(word.substr(5), option));
        if (background.roughness < 0.0f || background.roughness > 1.0f)
            refuse(option, word, "a background: the roughness must be from 0 to 1");
        return background;
    }
    if (word.find(',') == std::string::npos)
        refuse(option, word, "env, none, R,G,B or blur:ROUGHNESS");
    background.kind = Kind::color;
    background.color = parse_color(word, option);
    return background;
}

scene::Light parse_light(const std::string& word, const std::string& option)
{
    const std::size_t colon = word.find(':');
    const std::string kind = word.substr(0, colon);
    const std::string rest = colon == std::string::npos ? "" : word.substr(colon + 1);
    scene::Light light;
    if (kind == "directional") {
        const std::vector<double> numbers = parse_list(rest, {5, 5}, option);
        const float azimuth = turned(numbers[0]), elevation = turned(numbers[1]);
        light.kind = scene::LightKind::directional;
        light.direction = -glm::vec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                     std::cos(elevation) * std::cos(azimuth));
        light.intensity = vec3_at(numbers, 2);
    } else if (kind == "point") {
        const std::vector<double> numbers = parse_list(rest, {6, 6}, option);
        light.kind = scene::LightKind::point;
        light.position = vec3_at(numbers, 0);
        light.intensity = vec3_at(numbers, 3);
    } else {
        refuse(option, word, "directional:AZ,EL,R,G,B or point:X,Y,Z,R,G,B");
    }
    check_not_negative(light.intensity, word, option);
    return light;
}

glm::dvec3 light_place(const std::string& word, const std::string& option)
{
    if (!word.starts_with("point:"))
        return glm::dvec3(0.0);
    const std::vector<double> numbers = parse_list(word.substr(word.find(':') + 1), {6, 6}, option);
    return {numbers[0], numbers[1], numbers[2]};
}

} // namespace lambent::cli
