// Conversions between words of the command line and their values.
#pragma once

#include "draw/settings.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace lambent::cli {

struct Size {
    int width = 0, height = 0;
};

/// Parses a whole word as a finite number of magnitude at most 3e38. Throws Error(usage) naming `option`.
double parse_number(const std::string& word, const std::string& option);

/// "WxH", each from 1 to 65536 and at most 2^28 pixels. Throws Error(usage).
Size parse_size(const std::string& word, const std::string& option);

/// Numbers separated by commas; their count must be from `least` to `most`. Throws Error(usage).
struct Count {
    std::size_t least, most;
};
std::vector<double> parse_list(const std::string& word, Count count, const std::string& option);

/// "R,G,B", none negative. Throws Error(usage).
glm::vec3 parse_color(const std::string& word, const std::string& option);

/// "X,Y,Z", metres. Throws Error(usage).
glm::dvec3 parse_point(const std::string& word, const std::string& option);

/// "AZIMUTH,ELEVATION" or "AZIMUTH,ELEVATION,DISTANCE", degrees and metres. Throws Error(usage).
view::Orbit parse_orbit(const std::string& word, const std::string& option);

/// "env", "none", "R,G,B" or "blur:ROUGHNESS". Throws Error(usage).
draw::Background parse_background(const std::string& word, const std::string& option);

/// "directional:AZ,EL,R,G,B" (degrees towards the light, lux) or "point:X,Y,Z,R,G,B" (metres, candela).
/// Throws Error(usage).
scene::Light parse_light(const std::string& word, const std::string& option);

/// The position of such a light in double precision; the origin for a directional light. Throws Error(usage).
glm::dvec3 light_place(const std::string& word, const std::string& option);

float radians(double degrees);

/// An angle in degrees, brought into -180 to 180 degrees, in radians.
float turned(double degrees);

/// A number as a word of at most six digits.
std::string number_word(double value);

/// The shortest words, of at least six digits, that read back as the same values.
std::string exact_word(double value);
std::string exact_word(float value);
std::string degrees_word(float value); ///< degrees of an angle in radians
std::string value_word(const glm::vec3& color);
std::string value_word(const glm::dvec3& point);
std::string value_word(const view::Orbit& orbit);
std::string value_word(const draw::Background& background);
std::string size_word(Size size);

/// A number with at most `digits` significant digits.
std::string word_of_digits(double value, int digits);

} // namespace lambent::cli
