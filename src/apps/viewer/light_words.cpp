#include "apps/viewer/light_words.h"

#include "apps/options/values.h"
#include "apps/viewer/parameters.h"
#include "base/text.h"
#include "equations/in_double.h"

#include <algorithm>
#include <cmath>

namespace lambent::viewer {
namespace {

// Limits far above practical values and far below the largest float.
constexpr double farthest = 1e6, strongest = 1e9;

double finite_clamp(double value, double least, double most)
{
    return std::isfinite(value) ? std::clamp(value, least, most) : 0.0;
}

// Wraps angles in degrees: an elevation beyond a pole continues on the other side.
void wrap_angles(double& azimuth, double& elevation)
{
    elevation = std::remainder(finite_clamp(elevation, -1e6, 1e6), 360.0);
    if (std::abs(elevation) > 90.0) {
        elevation = std::copysign(180.0, elevation) - elevation;
        azimuth += 180.0;
    }
    azimuth = std::remainder(finite_clamp(azimuth, -1e6, 1e6), 360.0);
}

} // namespace

std::array<double, 3> screen_color(const std::array<double, 3>& linear)
{
    std::array<double, 3> screen{};
    for (std::size_t c = 0; c < 3; ++c)
        screen[c] = in_double::srgb_encode(finite_clamp(linear[c], 0.0, 1.0));
    return screen;
}

std::array<double, 3> linear_color(const std::array<double, 3>& screen)
{
    std::array<double, 3> linear{};
    for (std::size_t c = 0; c < 3; ++c)
        linear[c] = in_double::srgb_decode(finite_clamp(screen[c], 0.0, 1.0));
    return linear;
}

LightFields read_light(const std::string& word)
{
    cli::parse_light(word, "light");
    const std::vector<double> numbers = cli::parse_list(word.substr(word.find(':') + 1), {5, 6}, "light");
    LightFields light;
    light.is_sun = numbers.size() == 5;
    std::copy(numbers.begin(), numbers.end() - 3, light.place.begin());
    if (light.is_sun)
        wrap_angles(light.place[0], light.place[1]);
    std::array<double, 3> color{};
    std::copy(numbers.end() - 3, numbers.end(), color.begin());
    light.strength = *std::max_element(color.begin(), color.end());
    if (!(light.strength > 0.0))
        return light; // off, with the default colour white
    for (double& part : color)
        part /= light.strength;
    light.color = screen_color(color);
    return light;
}

std::string light_word(const LightFields& light)
{
    std::array<double, 3> color = linear_color(light.color), place = light.place;
    const double most = std::max({color[0], color[1], color[2]});
    const double strength = most > 0.0 ? finite_clamp(light.strength, 0.0, strongest) / most : 0.0;
    if (light.is_sun)
        wrap_angles(place[0], place[1]);
    std::string word = light.is_sun ? "directional:" : "point:";
    for (std::size_t i = 0; i < (light.is_sun ? 2u : 3u); ++i)
        word += text(place_word(finite_clamp(place[i], -farthest, farthest), 1e3), ",");
    return text(word, number_word(strength * color[0]), ",", number_word(strength * color[1]), ",",
                number_word(strength * color[2]));
}

} // namespace lambent::viewer
