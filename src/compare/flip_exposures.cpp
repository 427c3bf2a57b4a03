#include "compare/flip_exposures.h"

#include "equations/in_double.h"
#include "image/luminance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lambent::compare {
namespace {

// (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5): Narkowicz's curve, with the factor 0.6 in its arguments that he suggests to
// undo the reference transform's own exposure.
constexpr double k0 = 0.36 * 2.51, k1 = 0.6 * 0.03, k3 = 0.36 * 2.43, k4 = 0.6 * 0.59, k5 = 0.14;

// The level at which the brightest and the median pixel are shown (section 3.1).
constexpr double shown_level = 0.85;

// The light that the curve maps to `level`: the positive root.
double light_shown_as(double level)
{
    const double a = k0 - k3 * level, b = k1 - k4 * level, c = -k5 * level;
    return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

// The median; for an even number of values the mean of the middle two.
double median(std::vector<float>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    const double upper = *middle;
    if (values.size() % 2 == 1)
        return upper;
    return 0.5 * (upper + *std::max_element(values.begin(), middle));
}

std::vector<float> luminances(const image::RadianceImage& picture)
{
    std::vector<float> all;
    all.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            // The rounded weights may add up to more than 1, and the sum exceed the largest float.
            const double luminance = image::luminance(picture.pixel(x, y));
            all.push_back(static_cast<float>(std::clamp(luminance, 0.0, 3.4e38)));
        }
    return all;
}

constexpr int decoding_steps = 4096;

// Linear interpolation between these is within a float's last bit or two of the curve.
const std::array<float, decoding_steps + 2>& decoding_table()
{
    static const auto table = [] {
        std::array<float, decoding_steps + 2> values{};
        for (int i = 0; i <= decoding_steps; ++i)
            values[static_cast<std::size_t>(i)] =
                static_cast<float>(in_double::srgb_decode(static_cast<double>(i) / decoding_steps));
        values[decoding_steps + 1] = values[decoding_steps];
        return values;
    }();
    return table;
}

} // namespace

float decoded(float code)
{
    static const std::array<float, decoding_steps + 2>& table = decoding_table();
    const float position = std::clamp(code, 0.0f, 1.0f) * decoding_steps;
    const auto i = static_cast<std::size_t>(position);
    return table[i] + (table[i + 1] - table[i]) * (position - static_cast<float>(i));
}

float tone_mapped(float light)
{
    // Beyond 1e6 the curve is 1, and squares might not be finite.
    const float x = std::clamp(light, 0.0f, 1e6f);
    const float up = (static_cast<float>(k0) * x + static_cast<float>(k1)) * x;
    const float down = (static_cast<float>(k3) * x + static_cast<float>(k4)) * x + static_cast<float>(k5);
    return std::min(up / down, 1.0f);
}

int exposure_count(double start, double stop)
{
    if (!(stop > start))
        return 1;
    return static_cast<int>(std::clamp(std::ceil(stop - start), 2.0, static_cast<double>(most_exposures)));
}

Exposures exposures_for(const image::RadianceImage& reference)
{
    std::vector<float> luminance = luminances(reference);
    const double brightest =
        luminance.empty() ? 0.0 : static_cast<double>(*std::max_element(luminance.begin(), luminance.end()));
    if (!(brightest > 0.0))
        return {};
    double middle = median(luminance);
    if (!(middle > 0.0)) {
        std::erase_if(luminance, [](float value) { return !(value > 0.0f); });
        middle = median(luminance);
    }
    const double light = light_shown_as(shown_level);
    Exposures exposures{std::log2(light / brightest), std::log2(light / middle), 1};
    exposures.count = exposure_count(exposures.start, exposures.stop);
    return exposures;
}

} // namespace lambent::compare
