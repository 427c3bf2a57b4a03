#include "compare/color_map.h"

#include "compare/flip_color.h"
#include "equations/in_double.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::compare {
namespace {

constexpr int steps = 256;
constexpr double lightest = 96.0;
constexpr double most_chroma = 95.0; // more than the screen has; what does not fit is made paler
constexpr double first_hue = -75.0, last_hue = 105.0; // CIELAB degrees: violet, by red, to yellow

using Rgb = std::array<double, 3>;

// CIE 15: XYZ over white from the three arguments of the cube root's inverse.
double inverse_lab_curve(double t)
{
    constexpr double delta = 6.0 / 29.0;
    return t > delta ? t * t * t : 3.0 * delta * delta * (t - 4.0 / 29.0);
}

Rgb linear_of(double lightness, double chroma, double hue)
{
    const double y = (lightness + 16.0) / 116.0;
    const double xyz[3] = {inverse_lab_curve(y + chroma * std::cos(hue) / 500.0), inverse_lab_curve(y),
                           inverse_lab_curve(y - chroma * std::sin(hue) / 200.0)};
    Rgb rgb{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            rgb[i] += xyz_to_rgb[i][k] * xyz[k];
    return rgb;
}

bool fits(const Rgb& rgb)
{
    return std::all_of(rgb.begin(), rgb.end(), [](double part) { return part >= 0.0 && part <= 1.0; });
}

Code entry(double t)
{
    const double lightness = lightest * t;
    const double hue = (first_hue + (last_hue - first_hue) * std::pow(t, 0.8)) * std::numbers::pi / 180.0;
    double low = 0.0, high = most_chroma;
    for (int i = 0; i < 40; ++i) {
        const double chroma = 0.5 * (low + high);
        (fits(linear_of(lightness, chroma, hue)) ? low : high) = chroma;
    }
    const Rgb rgb = linear_of(lightness, low, hue);
    Code code{};
    for (std::size_t i = 0; i < 3; ++i)
        code[i] = static_cast<std::uint8_t>(
            std::lround(255.0 * in_double::srgb_encode(std::clamp(rgb[i], 0.0, 1.0))));
    return code;
}

std::array<Code, steps> make_table()
{
    std::array<Code, steps> table{};
    for (int i = 0; i < steps; ++i)
        table[static_cast<std::size_t>(i)] = entry(static_cast<double>(i) / (steps - 1));
    return table;
}

} // namespace

Code color_of(float error)
{
    static const std::array<Code, steps> table = make_table();
    if (!(error > 0.0f))
        return table.front();
    return table[static_cast<std::size_t>(std::min(error, 1.0f) * (steps - 1) + 0.5f)];
}

} // namespace lambent::compare
