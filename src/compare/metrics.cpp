#include "compare/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent::compare {
namespace {

// Calls visit(a, b) for every colour value of both.
template <class Visit>
void for_each_value(const image::RadianceImage& a, const image::RadianceImage& b, Visit&& visit)
{
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c)
                visit(static_cast<double>(a.pixel(x, y)[c]), static_cast<double>(b.pixel(x, y)[c]));
}

} // namespace

Metrics measure(const image::RadianceImage& picture, const image::RadianceImage& reference, double peak)
{
    double squares = 0.0, sum = 0.0, most = 0.0;
    for_each_value(picture, reference, [&](double a, double b) {
        squares += (a - b) * (a - b);
        sum += b;
        most = std::max(most, std::fabs(a - b));
    });
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double values = 3.0 * picture.width * picture.height;
    Metrics m;
    m.rmse = std::sqrt(squares / values);
    m.relative_rmse = m.rmse == 0.0 ? 0.0 : sum > 0.0 ? m.rmse / (sum / values) : infinity;
    m.psnr = m.rmse > 0.0 ? 20.0 * std::log10(peak / m.rmse) : infinity;
    m.max = most;
    return m;
}

float largest_value(const image::RadianceImage& image)
{
    float most = 0.0f;
    for_each_value(image, image, [&](double a, double) { most = std::max(most, static_cast<float>(a)); });
    return most;
}

void clamp_values(image::RadianceImage& image, float limit)
{
    for (float& value : image.values)
        value = std::clamp(value, 0.0f, limit);
}

std::uint64_t mend_values(image::RadianceImage& image)
{
    std::uint64_t broken = 0;
    for (float& value : image.values)
        if (!std::isfinite(value)) {
            value = 0.0f;
            ++broken;
        }
    return broken;
}

} // namespace lambent::compare
