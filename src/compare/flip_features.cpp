#include "compare/flip_features.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lambent::compare {
namespace {

// Width of the smallest feature that is sought, in degrees. [2020, section 4.2]
constexpr double feature_width = 0.082;

// A Gaussian and its first two derivatives. Of the derivatives, positive weights add up to 1 and negative ones to -1.
struct FeatureKernels {
    Kernel gaussian, edge, point;

    explicit FeatureKernels(double pixels_per_degree)
    {
        const double deviation = 0.5 * feature_width * pixels_per_degree;
        const int radius = static_cast<int>(std::ceil(3.0 * deviation));
        std::vector<double> g, e, p;
        for (int i = -radius; i <= radius; ++i) {
            const double weight = std::exp(-0.5 * i * i / (deviation * deviation));
            g.push_back(weight);
            e.push_back(-i * weight);
            p.push_back((i * i / (deviation * deviation) - 1.0) * weight);
        }
        gaussian = balanced(g), edge = balanced(e), point = balanced(p);
    }

private:
    static Kernel balanced(const std::vector<double>& weights)
    {
        double above = 0.0, below = 0.0;
        for (const double w : weights)
            (w > 0.0 ? above : below) += w;
        Kernel kernel;
        for (const double w : weights)
            kernel.push_back(static_cast<float>(w > 0.0 ? w / above : w < 0.0 ? -w / below : 0.0));
        return kernel;
    }
};

// Strength of the features along both axes.
Plane strength(const Plane& plane, const Kernel& derivative, const Kernel& gaussian)
{
    Plane across = filtered(plane, derivative, gaussian);
    const Plane down = filtered(plane, gaussian, derivative);
    for (std::size_t i = 0; i < across.values.size(); ++i)
        across.values[i] = std::hypot(across.values[i], down.values[i]);
    return across;
}

Plane unit(const Plane& achromatic)
{
    Plane plane = achromatic;
    for (float& value : plane.values)
        value = (value + 16.0f) / 116.0f;
    return plane;
}

} // namespace

Plane feature_difference(const Plane& picture, const Plane& reference, double pixels_per_degree)
{
    const FeatureKernels kernels(pixels_per_degree);
    const Plane a = unit(picture), b = unit(reference);
    const Plane edges_a = strength(a, kernels.edge, kernels.gaussian),
                edges_b = strength(b, kernels.edge, kernels.gaussian);
    const Plane points_a = strength(a, kernels.point, kernels.gaussian),
                points_b = strength(b, kernels.point, kernels.gaussian);
    Plane result(a.width, a.height);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        const float edge = std::fabs(edges_a.values[i] - edges_b.values[i]);
        const float point = std::fabs(points_a.values[i] - points_b.values[i]);
        result.values[i] = std::clamp(std::max(edge, point) * 0.70710678f, 0.0f, 1.0f);
    }
    return result;
}

} // namespace lambent::compare
