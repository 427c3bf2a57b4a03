#include "tests/compare/naive_flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace lambent::compare::test {
namespace {

constexpr double pi = std::numbers::pi;

using Triple = std::array<double, 3>;
using Triples = std::vector<Triple>;

double srgb_to_light(double code)
{
    return code > 0.04045 ? std::pow((code + 0.055) / 1.055, 2.4) : code / 12.92;
}

// IEC 61966-2-1 to four more digits than its table, and what the white comes to.
Triple light_to_xyz(const Triple& c)
{
    return {0.412386564 * c[0] + 0.357591436 * c[1] + 0.180450467 * c[2],
            0.212636903 * c[0] + 0.715183011 * c[1] + 0.072180086 * c[2],
            0.019330625 * c[0] + 0.119197239 * c[1] + 0.950372508 * c[2]};
}
constexpr Triple white = {0.950428467, 1.0, 1.088900372};

Triple xyz_to_light(const Triple& c)
{
    return {3.241003275 * c[0] - 1.537398934 * c[1] - 0.498615861 * c[2],
            -0.969224334 * c[0] + 1.875930071 * c[1] + 0.041554224 * c[2],
            0.055639423 * c[0] - 0.204011202 * c[1] + 1.057148933 * c[2]};
}

Triple ycxcz(const Triple& light)
{
    const Triple xyz = light_to_xyz(light);
    const double x = xyz[0] / white[0], y = xyz[1], z = xyz[2] / white[2];
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

Triple ycxcz_to_light(const Triple& c)
{
    const double y = (c[0] + 16.0) / 116.0;
    return xyz_to_light({(y + c[1] / 500.0) * white[0], y, (y - c[2] / 200.0) * white[2]});
}

Triple hunt_lab(const Triple& light)
{
    const Triple xyz = light_to_xyz(light);
    Triple f{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double t = xyz[i] / white[i];
        f[i] = t > std::pow(6.0 / 29.0, 3.0) ? std::cbrt(t) : t / (3.0 * 36.0 / 841.0) + 4.0 / 29.0;
    }
    const double lightness = 116.0 * f[1] - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (f[0] - f[1]), 0.01 * lightness * 200.0 * (f[1] - f[2])};
}

double hyab(const Triple& p, const Triple& q)
{
    return std::fabs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

struct Size {
    int width, height;

    std::size_t nearest(int x, int y) const
    {
        x = std::clamp(x, 0, width - 1);
        y = std::clamp(y, 0, height - 1);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

// One channel of the picture around a pixel.
struct Around {
    const Triples& values;
    const Size& size;
    int x, y;

    double at(int dx, int dy, std::size_t channel) const
    {
        return values[size.nearest(x + dx, y + dy)][channel];
    }
};

// The sum of weights times the values around a pixel; transposed: x and y of the weights exchanged.
double filtered(const Around& around, std::size_t channel, const Square& square, bool transposed = false)
{
    double sum = 0.0;
    for (int dy = -square.radius; dy <= square.radius; ++dy)
        for (int dx = -square.radius; dx <= square.radius; ++dx)
            sum += (transposed ? square.at(dy, dx) : square.at(dx, dy)) * around.at(dx, dy, channel);
    return sum;
}

struct Filters {
    Square achromatic, red_green, blue_yellow, edge, point;
};

// Hunt-adjusted colour, strength of edges, of points.
struct Seen {
    Triple color;
    double edge, point;
};

Seen seen(const Around& opponent, const Filters& f)
{
    Triple light = ycxcz_to_light({filtered(opponent, 0, f.achromatic), filtered(opponent, 1, f.red_green),
                                   filtered(opponent, 2, f.blue_yellow)});
    for (double& part : light)
        part = std::clamp(part, 0.0, 1.0);
    const auto strength = [&](const Square& square) {
        return std::hypot(filtered(opponent, 0, square), filtered(opponent, 0, square, true)) / 116.0;
    };
    return {hunt_lab(light), strength(f.edge), strength(f.point)};
}

double error_between(const Seen& p, const Seen& q)
{
    const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7),
                 bend = 0.4 * largest;
    const double power = std::pow(hyab(p.color, q.color), 0.7);
    const double color = power < bend ? 0.95 * power / bend : 0.95 + 0.05 * (power - bend) / (largest - bend);
    const double feature = std::max(std::fabs(p.edge - q.edge), std::fabs(p.point - q.point));
    return std::pow(color, 1.0 - std::pow(feature / std::numbers::sqrt2, 0.5));
}

std::vector<double> flip_of_light(const Triples& picture, const Triples& reference, const Size& size,
                                  double pixels_per_degree)
{
    const Filters f = {naive_contrast_filter(Channel::achromatic, pixels_per_degree),
                       naive_contrast_filter(Channel::red_green, pixels_per_degree),
                       naive_contrast_filter(Channel::blue_yellow, pixels_per_degree),
                       naive_feature_filter(false, pixels_per_degree),
                       naive_feature_filter(true, pixels_per_degree)};
    Triples p, q;
    std::transform(picture.begin(), picture.end(), std::back_inserter(p), ycxcz);
    std::transform(reference.begin(), reference.end(), std::back_inserter(q), ycxcz);
    std::vector<double> errors;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            errors.push_back(error_between(seen({p, size, x, y}, f), seen({q, size, x, y}, f)));
    return errors;
}

Triples triples(const image::RadianceImage& picture, const std::function<double(double)>& change)
{
    Triples values;
    for (std::size_t i = 0; i < picture.values.size(); i += 3)
        values.push_back({change(static_cast<double>(picture.values[i])),
                          change(static_cast<double>(picture.values[i + 1])),
                          change(static_cast<double>(picture.values[i + 2]))});
    return values;
}

double aces(double light)
{
    const double x = 0.6 * std::max(light, 0.0);
    return std::clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

// By halving, where the curve reaches 0.85.
double light_shown_as_0_85()
{
    double low = 0.0, high = 100.0;
    for (int i = 0; i < 200; ++i)
        (aces(0.5 * (low + high)) < 0.85 ? low : high) = 0.5 * (low + high);
    return low;
}

} // namespace

Square naive_contrast_filter(Channel channel, double pixels_per_degree)
{
    // a1, b1, a2, b2 of the paper's table 1.
    const std::array<double, 4> table[3] = {
        {1.0, 0.0047, 0.0, 1e-5}, {1.0, 0.0053, 0.0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
    const auto [a1, b1, a2, b2] = table[static_cast<std::size_t>(channel)];
    Square square;
    square.radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * pi * pi)) * pixels_per_degree));
    double sum = 0.0;
    for (int y = -square.radius; y <= square.radius; ++y)
        for (int x = -square.radius; x <= square.radius; ++x) {
            const double d2 = (x * x + y * y) / (pixels_per_degree * pixels_per_degree);
            square.weights.push_back(a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * d2 / b1) +
                                     a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * d2 / b2));
            sum += square.weights.back();
        }
    for (double& weight : square.weights)
        weight /= sum;
    return square;
}

Square naive_feature_filter(bool point, double pixels_per_degree)
{
    const double deviation = 0.5 * 0.082 * pixels_per_degree;
    Square square;
    square.radius = static_cast<int>(std::ceil(3.0 * deviation));
    double negative = 0.0, positive = 0.0;
    for (int y = -square.radius; y <= square.radius; ++y)
        for (int x = -square.radius; x <= square.radius; ++x) {
            const double gaussian = std::exp(-(x * x + y * y) / (2.0 * deviation * deviation));
            const double weight = gaussian * (point ? x * x / (deviation * deviation) - 1.0 : -x);
            square.weights.push_back(weight);
            (weight < 0.0 ? negative : positive) += std::fabs(weight);
        }
    for (double& weight : square.weights)
        weight /= weight < 0.0 ? negative : positive;
    return square;
}

std::vector<double> naive_ldr_flip(const image::RadianceImage& picture, const image::RadianceImage& reference,
                                   double pixels_per_degree)
{
    return flip_of_light(triples(picture, srgb_to_light), triples(reference, srgb_to_light),
                         {picture.width, picture.height}, pixels_per_degree);
}

std::vector<double> naive_hdr_flip(const image::RadianceImage& picture, const image::RadianceImage& reference,
                                   double pixels_per_degree)
{
    std::vector<double> luminance;
    for (const Triple& c : triples(reference, [](double v) { return v; }))
        luminance.push_back(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
    std::sort(luminance.begin(), luminance.end());
    const std::size_t n = luminance.size();
    const double median = 0.5 * (luminance[(n - 1) / 2] + luminance[n / 2]);
    const double start = std::log2(light_shown_as_0_85() / luminance.back());
    const double stop = std::log2(light_shown_as_0_85() / median);
    const int count = std::max(2, static_cast<int>(std::ceil(stop - start)));
    std::vector<double> worst(n);
    for (int i = 0; i < count; ++i) {
        const double factor = std::exp2(start + (stop - start) * i / (count - 1));
        const auto shown = [factor](double light) { return aces(factor * light); };
        const std::vector<double> errors = flip_of_light(triples(picture, shown), triples(reference, shown),
                                                         {picture.width, picture.height}, pixels_per_degree);
        for (std::size_t k = 0; k < n; ++k)
            worst[k] = std::max(worst[k], errors[k]);
    }
    return worst;
}

} // namespace lambent::compare::test
