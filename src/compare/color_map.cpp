#include "compare/color_map.h"

#include "compare/flip_color.h"
#include "equations/in_double.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lambent::compare {
namespace {

constexpr int steps = 256;
constexpr double lightest = 96.0;
constexpr double most_chroma = 95.0; // above the display's range; colours outside it are made paler
constexpr double first_hue = -75.0, last_hue = 105.0; // CIELAB degrees: violet, by red, to yellow

constexpr int smoothing = 22; // entries to either side

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

struct LightnessAndHue {
    double lightness, hue;
};

LightnessAndHue lightness_and_hue(int i)
{
    const double t = static_cast<double>(i) / (steps - 1);
    const double degrees = first_hue + (last_hue - first_hue) * std::pow(t, 0.8);
    return {lightest * t, degrees * std::numbers::pi / 180.0};
}

// The largest chroma that a display has at a lightness and hue, by bisection.
double chroma_at(const LightnessAndHue& entry)
{
    double low = 0.0, high = most_chroma;
    for (int i = 0; i < 40; ++i) {
        const double chroma = 0.5 * (low + high);
        (fits(linear_of(entry.lightness, chroma, entry.hue)) ? low : high) = chroma;
    }
    return low;
}

using Chromas = std::array<double, steps>;

// Replaces each entry by pick(begin, end) of the entries around it.
template <class Pick>
Chromas around(const Chromas& chromas, Pick&& pick)
{
    Chromas picked{};
    for (int i = 0; i < steps; ++i)
        picked[static_cast<std::size_t>(i)] = pick(chromas.begin() + std::max(i - smoothing, 0),
                                                   chromas.begin() + std::min(i + smoothing + 1, steps));
    return picked;
}

// The largest chromas, smoothed, as corners of the display's range would look like edges in an image: the mean of the
// smallest values nearby is nowhere above the largest possible.
Chromas smooth_chromas()
{
    Chromas most{};
    for (int i = 0; i < steps; ++i)
        most[static_cast<std::size_t>(i)] = chroma_at(lightness_and_hue(i));
    const Chromas least = around(most, [](auto begin, auto end) { return *std::min_element(begin, end); });
    return around(least, [](auto begin, auto end) {
        return std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
    });
}

std::array<Code, steps> make_table()
{
    const Chromas chromas = smooth_chromas();
    std::array<Code, steps> table{};
    for (int i = 0; i < steps; ++i) {
        const LightnessAndHue entry = lightness_and_hue(i);
        const Rgb rgb = linear_of(entry.lightness, chromas[static_cast<std::size_t>(i)], entry.hue);
        for (std::size_t c = 0; c < 3; ++c)
            table[static_cast<std::size_t>(i)][c] = static_cast<std::uint8_t>(
                std::lround(255.0 * in_double::srgb_encode(std::clamp(rgb[c], 0.0, 1.0))));
    }
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
