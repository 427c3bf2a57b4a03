#include "compare/flip_color.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::compare {
namespace {

constexpr double pi = std::numbers::pi;

// Linear sRGB to XYZ for D65 and back. [IEC 61966-2-1, with the primaries' exact inverse]
constexpr float to_xyz[3][3] = {{0.4124564f, 0.3575761f, 0.1804375f},
                                {0.2126729f, 0.7151522f, 0.0721750f},
                                {0.0193339f, 0.1191920f, 0.9503041f}};
constexpr float to_rgb[3][3] = {{3.2404542f, -1.5371385f, -0.4985314f},
                                {-0.9692660f, 1.8760108f, 0.0415560f},
                                {0.0556434f, -0.2040259f, 1.0572252f}};

// XYZ of linear white by the same matrix.
constexpr float white[3] = {0.95047f, 1.0f, 1.08883f};

// A sum of Gaussians in cycles per degree: a1 exp(-b1 f^2) + a2 exp(-b2 f^2), the eye's sensitivity to each channel.
// [2020, table 1]
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity achromatic_eye{1.0, 0.0047, 0.0, 1e-5}, red_green_eye{1.0, 0.0053, 0.0, 1e-5},
    blue_yellow_eye{34.1, 0.04, 13.5, 0.025};

// Where differences in colour are compressed and how. [2020, section 4.1.3]
constexpr float color_exponent = 0.7f, large_from = 0.4f, large_is = 0.95f;

Triple times(const float (&m)[3][3], const Triple& v)
{
    return {m[0][0] * v.a + m[0][1] * v.b + m[0][2] * v.c, m[1][0] * v.a + m[1][1] * v.b + m[1][2] * v.c,
            m[2][0] * v.a + m[2][1] * v.b + m[2][2] * v.c};
}

float lab_root(float t)
{
    constexpr float delta = 6.0f / 29.0f;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
}

// One Gaussian in space, exp(-pi^2 x^2 / b) at x degrees, and the sum of its two-dimensional weights.
struct SpaceGaussian {
    Kernel kernel;
    double sum;
};

SpaceGaussian space_gaussian(double b, int radius, double pixels_per_degree)
{
    SpaceGaussian g;
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / pixels_per_degree, weight = std::exp(-pi * pi * x * x / b);
        g.kernel.push_back(static_cast<float>(weight));
        sum += weight;
    }
    for (float& weight : g.kernel)
        weight = static_cast<float>(static_cast<double>(weight) / sum);
    g.sum = sum * sum;
    return g;
}

// Three standard deviations of the widest filter.
int radius_for(double pixels_per_degree)
{
    return static_cast<int>(
        std::ceil(3.0 * std::sqrt(blue_yellow_eye.b1 / (2.0 * pi * pi)) * pixels_per_degree));
}

Plane seen(const Plane& plane, const Sensitivity& eye, double pixels_per_degree)
{
    const int radius = radius_for(pixels_per_degree);
    const SpaceGaussian first = space_gaussian(eye.b1, radius, pixels_per_degree);
    Plane result = filtered(plane, first.kernel, first.kernel);
    if (eye.a2 == 0.0)
        return result;
    const SpaceGaussian second = space_gaussian(eye.b2, radius, pixels_per_degree);
    const Plane other = filtered(plane, second.kernel, second.kernel);
    const double w1 = eye.a1 * std::sqrt(pi / eye.b1) * first.sum,
                 w2 = eye.a2 * std::sqrt(pi / eye.b2) * second.sum;
    const float share = static_cast<float>(w1 / (w1 + w2));
    for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = share * result.values[i] + (1.0f - share) * other.values[i];
    return result;
}

// The three channels as the eye blurs them.
struct Seen {
    Plane achromatic, red_green, blue_yellow;

    Seen(const OpponentPlanes& p, double pixels_per_degree)
        : achromatic(seen(p.achromatic, achromatic_eye, pixels_per_degree)),
          red_green(seen(p.red_green, red_green_eye, pixels_per_degree)),
          blue_yellow(seen(p.blue_yellow, blue_yellow_eye, pixels_per_degree))
    {
    }

    Triple color(int x, int y) const
    {
        const Triple rgb =
            linear_of_opponent({achromatic.row(y)[x], red_green.row(y)[x], blue_yellow.row(y)[x]});
        const auto cut = [](float v) { return std::clamp(v, 0.0f, 1.0f); };
        return hunt_adjusted(lab_of_linear({cut(rgb.a), cut(rgb.b), cut(rgb.c)}));
    }
};

float difference(const Triple& a, const Triple& b)
{
    return std::pow(hyab(a, b), color_exponent);
}

// Between the two most different colours of a display, green and blue.
float largest_difference()
{
    return difference(hunt_adjusted(lab_of_linear({0.0f, 1.0f, 0.0f})),
                      hunt_adjusted(lab_of_linear({0.0f, 0.0f, 1.0f})));
}

// To 0 to 1, the large ones pushed together.
float redistributed(float d, float largest)
{
    const float limit = large_from * largest;
    return d < limit ? large_is / limit * d : large_is + (d - limit) / (largest - limit) * (1.0f - large_is);
}

} // namespace

Triple opponent_of_linear(const Triple& rgb)
{
    const Triple xyz = times(to_xyz, rgb);
    const float x = xyz.a / white[0], y = xyz.b / white[1], z = xyz.c / white[2];
    return {116.0f * y - 16.0f, 500.0f * (x - y), 200.0f * (y - z)};
}

Triple linear_of_opponent(const Triple& opponent)
{
    const float y = (opponent.a + 16.0f) / 116.0f;
    const float x = y + opponent.b / 500.0f, z = y - opponent.c / 200.0f;
    return times(to_rgb, {x * white[0], y * white[1], z * white[2]});
}

Triple lab_of_linear(const Triple& rgb)
{
    const Triple xyz = times(to_xyz, rgb);
    const float x = lab_root(xyz.a / white[0]), y = lab_root(xyz.b / white[1]),
                z = lab_root(xyz.c / white[2]);
    return {116.0f * y - 16.0f, 500.0f * (x - y), 200.0f * (y - z)};
}

Triple hunt_adjusted(const Triple& lab)
{
    return {lab.a, 0.01f * lab.a * lab.b, 0.01f * lab.a * lab.c};
}

float hyab(const Triple& a, const Triple& b)
{
    return std::fabs(a.a - b.a) + std::hypot(a.b - b.b, a.c - b.c);
}

OpponentPlanes::OpponentPlanes(const image::RadianceImage& linear)
    : achromatic(linear.width, linear.height), red_green(linear.width, linear.height),
      blue_yellow(linear.width, linear.height)
{
    tbb::parallel_for(0, linear.height, [&](int y) {
        for (int x = 0; x < linear.width; ++x) {
            const float* rgb = linear.pixel(x, y);
            const Triple c = opponent_of_linear({rgb[0], rgb[1], rgb[2]});
            achromatic.row(y)[x] = c.a;
            red_green.row(y)[x] = c.b;
            blue_yellow.row(y)[x] = c.c;
        }
    });
}

Plane color_difference(const OpponentPlanes& picture, const OpponentPlanes& reference,
                       double pixels_per_degree)
{
    const Seen a(picture, pixels_per_degree), b(reference, pixels_per_degree);
    const float largest = largest_difference();
    Plane result(a.achromatic.width, a.achromatic.height);
    tbb::parallel_for(0, result.height, [&](int y) {
        for (int x = 0; x < result.width; ++x)
            result.row(y)[x] = redistributed(difference(a.color(x, y), b.color(x, y)), largest);
    });
    return result;
}

} // namespace lambent::compare
