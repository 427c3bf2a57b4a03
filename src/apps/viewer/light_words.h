// Words of --light as the fields of controls, and back.
#pragma once

#include <array>
#include <string>

namespace lambent::viewer {

/// A lamp or a sun for people: where it is, how strong, and its colour as screens have it.
struct LightFields {
    bool is_sun = false;
    std::array<double, 3> place{}; ///< a sun's azimuth and elevation, degrees; a lamp's x, y, z, metres
    double strength = 1.0;         ///< of its strongest channel: lux of a sun, candela of a lamp
    std::array<double, 3> color{1.0, 1.0, 1.0}; ///< sRGB, 0 to 1
};

/// A sun's angles are brought to -180 to 180 and -90 to 90. Throws Error(usage) as cli::parse_light.
LightFields read_light(const std::string& word);

/// The word of --light, to six digits. Whatever is in the fields it is one that can be parsed: numbers that are none
/// become 0, others are cut to what lights may be. The colour's brightness says nothing unless it is black: that is off.
std::string light_word(const LightFields& light);

/// A linear colour, cut to 0 to 1, as sRGB, and back.
std::array<double, 3> screen_color(const std::array<double, 3>& linear);
std::array<double, 3> linear_color(const std::array<double, 3>& screen);

} // namespace lambent::viewer
