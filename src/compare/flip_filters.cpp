#include "compare/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lambent::compare {
namespace {

constexpr double pi = std::numbers::pi;

// a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees: the contrast sensitivity's Fourier transform (equation 5, table 1).
struct Sensitivity {
    double a, b;
};
constexpr Sensitivity to_light{1.0, 0.0047}, to_red_green{1.0, 0.0053},
    to_blue_yellow[2] = {{34.1, 0.04}, {13.5, 0.025}};

// Visual angle in degrees between the trough and the peak of an edge detector (section 4.2.1).
constexpr double edge_width = 0.082;

// Filters are cut where weights, relative to the largest, are too small to change a sum of floats.
constexpr double least_weight = 1e-10;

// Weights for the offsets -n to n.
using Weights = std::vector<double>;

Filter finished(const Weights& weights, Shape shape = Shape::even)
{
    const double largest = std::fabs(*std::max_element(
        weights.begin(), weights.end(), [](double p, double q) { return std::fabs(p) < std::fabs(q); }));
    std::size_t cut = 0;
    while (2 * cut + 1 < weights.size() && std::fabs(weights[cut]) < least_weight * largest)
        ++cut;
    Filter filter;
    filter.shape = shape;
    filter.radius = static_cast<int>((weights.size() - 1) / 2 - cut);
    for (std::size_t i = cut; i < weights.size() - cut; ++i)
        filter.weights.push_back(static_cast<float>(weights[i]));
    return filter;
}

// Tabulates weight(offset) from -radius to radius.
template <class Weight>
Weights tabulated(int radius, Weight&& weight)
{
    Weights weights;
    for (int i = -radius; i <= radius; ++i)
        weights.push_back(weight(static_cast<double>(i)));
    return weights;
}

double sum(const Weights& weights)
{
    double sum = 0.0;
    for (const double w : weights)
        sum += w;
    return sum;
}

// Scales negative weights to a sum of -1 and positive ones to a sum of 1; a Gaussian has only positive ones.
Weights normalised(Weights weights)
{
    double negative = 0.0, positive = 0.0;
    for (const double w : weights)
        (w < 0.0 ? negative : positive) += std::fabs(w);
    for (double& w : weights)
        w /= w < 0.0 ? negative : positive;
    return weights;
}

Weights sensitivity(const Sensitivity& s, double pixels_per_degree, int radius)
{
    return tabulated(radius, [&](double i) {
        const double degrees = i / pixels_per_degree;
        return std::exp(-pi * pi * degrees * degrees / s.b);
    });
}

void add_contrast_filters(double pixels_per_degree, FlipFilters& filters)
{
    // All have the radius of three standard deviations of the widest (section 4.1.2).
    const double widest = std::sqrt(to_blue_yellow[0].b / (2.0 * pi * pi));
    const int radius = static_cast<int>(std::ceil(3.0 * widest * pixels_per_degree));
    filters.achromatic = finished(normalised(sensitivity(to_light, pixels_per_degree, radius)));
    filters.red_green = finished(normalised(sensitivity(to_red_green, pixels_per_degree, radius)));
    double shares[2];
    for (int k = 0; k < 2; ++k) {
        const Weights weights = sensitivity(to_blue_yellow[k], pixels_per_degree, radius);
        // The sum of the weights in two dimensions.
        shares[k] = to_blue_yellow[k].a * std::sqrt(pi / to_blue_yellow[k].b) * sum(weights) * sum(weights);
        filters.blue_yellow[k] = finished(normalised(weights));
    }
    for (int k = 0; k < 2; ++k)
        filters.blue_yellow_share[k] = static_cast<float>(shares[k] / (shares[0] + shares[1]));
    filters.radius = radius;
}

void add_feature_filters(double pixels_per_degree, FlipFilters& filters)
{
    const double deviation = 0.5 * edge_width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const auto gaussian = [&](double i) { return std::exp(-i * i / (2.0 * deviation * deviation)); };
    filters.smooth = finished(normalised(tabulated(radius, gaussian)));
    const auto slope = [&](double i) { return -i * gaussian(i); };
    const auto curvature = [&](double i) { return (i * i / (deviation * deviation) - 1.0) * gaussian(i); };
    filters.edge = finished(normalised(tabulated(radius, slope)), Shape::odd);
    filters.point = finished(normalised(tabulated(radius, curvature)), Shape::zero_sum);
    filters.radius = std::max(filters.radius, radius);
}

} // namespace

FlipFilters make_flip_filters(double pixels_per_degree)
{
    if (!(pixels_per_degree >= least_pixels_per_degree && pixels_per_degree <= most_pixels_per_degree))
        throw std::invalid_argument("pixels per degree are out of range");
    FlipFilters filters;
    add_contrast_filters(pixels_per_degree, filters);
    add_feature_filters(pixels_per_degree, filters);
    return filters;
}

} // namespace lambent::compare
