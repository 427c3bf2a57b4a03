// Conversions between words of --light and the fields of controls.
#pragma once

#include <array>
#include <string>

namespace lambent::viewer {

/// A light as controls show it: a sun (directional) or a lamp (point).
struct LightFields {
    bool is_sun = false;
    std::array<double, 3> place{}; ///< a sun's azimuth and elevation, degrees; a lamp's x, y, z, metres
    double strength = 1.0;         ///< of its strongest channel: lux of a sun, candela of a lamp
    std::array<double, 3> color{1.0, 1.0, 1.0}; ///< sRGB, 0 to 1
};

/// A sun's angles are brought to -180 to 180 and -90 to 90. Throws Error(usage) as cli::parse_light.
LightFields read_light(const std::string& word);

/// The word of --light, to six digits. It can always be parsed: values that are not finite become 0, others are
/// clamped. Only the ratios of the colour's channels count, except that black turns the light off.
std::string light_word(const LightFields& light);

/// Conversions between linear and sRGB colours, both clamped to 0 to 1.
std::array<double, 3> screen_color(const std::array<double, 3>& linear);
std::array<double, 3> linear_color(const std::array<double, 3>& screen);

} // namespace lambent::viewer
