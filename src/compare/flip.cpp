#include "compare/flip.h"

#include "compare/flip_color.h"
#include "compare/flip_features.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lambent::compare {
namespace {

// Exponent of the feature difference. [2020, section 4.3]
constexpr float feature_exponent = 0.5f;

// The tone curve of HDR-FLIP, a rational fit to ACES: (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5).
// [Narkowicz 2016, with the input times 0.6; 2021, section 3.1]
constexpr double k0 = 0.6 * 0.6 * 2.51, k1 = 0.6 * 0.03, k3 = 0.6 * 0.6 * 2.43, k4 = 0.6 * 0.59, k5 = 0.14;

// What the curve shows at this is what the exposures are chosen by. [2021, section 3.2]
constexpr double shown = 0.85;

// Of the reference's median luminance at least this, or a mostly black picture would be exposed without end.
constexpr double least_luminance = 1e-5;

double luminance(const float* rgb)
{
    return 0.2126 * static_cast<double>(rgb[0]) + 0.7152 * static_cast<double>(rgb[1]) +
           0.0722 * static_cast<double>(rgb[2]);
}

image::RadianceImage tone_mapped(const image::RadianceImage& light, double exposure)
{
    image::RadianceImage image{light.width, light.height, 3, {}};
    image.values.resize(static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.height) * 3);
    const double factor = std::exp2(exposure);
    tbb::parallel_for(0, light.height, [&](int y) {
        for (int x = 0; x < light.width; ++x)
            for (int c = 0; c < 3; ++c) {
                // Brighter than this is white; its square leaves the range.
                const double v = std::clamp(factor * static_cast<double>(light.pixel(x, y)[c]), 0.0, 1e9);
                const double curve = (k0 * v * v + k1 * v) / (k3 * v * v + k4 * v + k5);
                image.pixel(x, y)[c] = static_cast<float>(std::min(curve, 1.0));
            }
    });
    return image;
}

} // namespace

Plane flip(const image::RadianceImage& picture, const image::RadianceImage& reference,
           double pixels_per_degree)
{
    const OpponentPlanes a(picture), b(reference);
    const Plane color = color_difference(a, b, pixels_per_degree);
    const Plane feature = feature_difference(a.achromatic, b.achromatic, pixels_per_degree);
    Plane result(picture.width, picture.height);
    tbb::parallel_for(0, picture.height, [&](int y) {
        for (int x = 0; x < picture.width; ++x)
            result.row(y)[x] =
                std::pow(color.row(y)[x], 1.0f - std::pow(feature.row(y)[x], feature_exponent));
    });
    return result;
}

Exposures exposures_for(const image::RadianceImage& reference)
{
    std::vector<double> luminances;
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x)
            luminances.push_back(luminance(reference.pixel(x, y)));
    const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    const double median = std::max(*middle, least_luminance);
    const double brightest =
        std::max(*std::max_element(luminances.begin(), luminances.end()), least_luminance);
    // The light that the curve shows at 0.85: the positive root of its quadratic.
    const double a = k0 - shown * k3, b = k1 - shown * k4, c = -shown * k5;
    const double light = (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
    Exposures e;
    e.start = std::log2(light / brightest);
    e.stop = std::log2(light / median);
    e.count = std::max(2, static_cast<int>(std::ceil(e.stop - e.start)));
    return e;
}

Plane hdr_flip(const image::RadianceImage& picture, const image::RadianceImage& reference,
               double pixels_per_degree)
{
    const Exposures e = exposures_for(reference);
    Plane most(picture.width, picture.height);
    for (int i = 0; i < e.count; ++i) {
        const double exposure = e.start + (e.stop - e.start) * i / (e.count - 1);
        const Plane one =
            flip(tone_mapped(picture, exposure), tone_mapped(reference, exposure), pixels_per_degree);
        std::transform(most.values.begin(), most.values.end(), one.values.begin(), most.values.begin(),
                       [](float a, float b) { return std::max(a, b); });
    }
    return most;
}

double mean(const Plane& plane)
{
    double sum = 0.0;
    for (const float value : plane.values)
        sum += static_cast<double>(value);
    return sum / static_cast<double>(plane.values.size());
}

} // namespace lambent::compare
