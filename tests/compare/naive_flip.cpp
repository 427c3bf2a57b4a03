#include "tests/compare/naive_flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace lambent::compare::testing {
namespace {

using Color = std::array<double, 3>;
using Picture = std::vector<Color>;

constexpr double pi = 3.14159265358979323846;

struct Size {
    int width, height;
};

// sRGB's matrix from the chromaticities of its primaries and D65, solved here instead of copied.
struct Matrix {
    double m[3][3];

    Color operator*(const Color& v) const
    {
        Color r{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                r[i] += m[i][j] * v[j];
        return r;
    }
};

Matrix inverse(const Matrix& a)
{
    Matrix r{};
    const auto minor = [&](int i, int j) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        return a.m[i1][j1] * a.m[i2][j2] - a.m[i1][j2] * a.m[i2][j1];
    };
    const double determinant = a.m[0][0] * minor(0, 0) + a.m[0][1] * minor(0, 1) + a.m[0][2] * minor(0, 2);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            r.m[i][j] = minor(j, i) / determinant;
    return r;
}

Color xyz_of(double x, double y)
{
    return {x / y, 1.0, (1.0 - x - y) / y};
}

Matrix rgb_to_xyz()
{
    const Color r = xyz_of(0.64, 0.33), g = xyz_of(0.30, 0.60), b = xyz_of(0.15, 0.06);
    Matrix primaries{};
    for (std::size_t i = 0; i < 3; ++i)
        primaries.m[i][0] = r[i], primaries.m[i][1] = g[i], primaries.m[i][2] = b[i];
    const Color shares = inverse(primaries) * xyz_of(0.3127, 0.3290);
    for (auto& row : primaries.m)
        for (std::size_t j = 0; j < 3; ++j)
            row[j] *= shares[j];
    return primaries;
}

Color relative(const Color& rgb)
{
    static const Matrix to_xyz = rgb_to_xyz();
    const Color v = to_xyz * rgb, white = to_xyz * Color{1.0, 1.0, 1.0};
    return {v[0] / white[0], v[1] / white[1], v[2] / white[2]};
}

Color opponent(const Color& rgb)
{
    const Color v = relative(rgb);
    return {116.0 * v[1] - 16.0, 500.0 * (v[0] - v[1]), 200.0 * (v[1] - v[2])};
}

Color linear(const Color& c)
{
    static const Matrix to_xyz = rgb_to_xyz(), to_rgb = inverse(to_xyz);
    const Color white = to_xyz * Color{1.0, 1.0, 1.0};
    const double y = (c[0] + 16.0) / 116.0;
    return to_rgb * Color{(y + c[1] / 500.0) * white[0], y * white[1], (y - c[2] / 200.0) * white[2]};
}

Color hunt_lab(const Color& rgb)
{
    const Color v = relative(rgb);
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double L = 116.0 * f(v[1]) - 16.0;
    return {L, 0.01 * L * 500.0 * (f(v[0]) - f(v[1])), 0.01 * L * 200.0 * (f(v[1]) - f(v[2]))};
}

double hyab_power(const Color& a, const Color& b)
{
    return std::pow(std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), 0.7);
}

// A kernel of two dimensions at pixel offsets, made to sum to 1 (or to 1 and -1 where it has both signs).
struct Square {
    int radius;
    std::vector<double> weights;

    Square(int r, const std::function<double(int, int)>& weight) : radius(r)
    {
        double above = 0.0, below = 0.0;
        for (int y = -r; y <= r; ++y)
            for (int x = -r; x <= r; ++x) {
                weights.push_back(weight(x, y));
                (weights.back() > 0.0 ? above : below) += weights.back();
            }
        for (double& w : weights)
            w /= w > 0.0 ? above : below < 0.0 ? -below : 1.0;
    }

    double at(const Size& size, int px, int py, const std::function<double(std::size_t)>& value) const
    {
        double sum = 0.0;
        std::size_t i = 0;
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x, ++i) {
                const int cx = std::clamp(px + x, 0, size.width - 1),
                          cy = std::clamp(py + y, 0, size.height - 1);
                sum += weights[i] * value(static_cast<std::size_t>(cy * size.width + cx));
            }
        return sum;
    }
};

struct Eye {
    double a1, b1, a2, b2;
};

Square eye_filter(const Eye& e, double ppd)
{
    const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * pi * pi)) * ppd));
    return Square(radius, [&](int x, int y) {
        const double d2 = (x * x + y * y) / (ppd * ppd);
        return e.a1 * std::sqrt(pi / e.b1) * std::exp(-pi * pi * d2 / e.b1) +
               e.a2 * std::sqrt(pi / e.b2) * std::exp(-pi * pi * d2 / e.b2);
    });
}

Picture opponents(const image::RadianceImage& image)
{
    Picture picture;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float* p = image.pixel(x, y);
            picture.push_back(opponent({p[0], p[1], p[2]}));
        }
    return picture;
}

Color seen(const Picture& p, const Size& size, int x, int y, const std::array<Square, 3>& eyes)
{
    Color c;
    for (std::size_t k = 0; k < 3; ++k)
        c[k] = eyes[k].at(size, x, y, [&](std::size_t i) { return p[i][k]; });
    c = linear(c);
    for (double& v : c)
        v = std::clamp(v, 0.0, 1.0);
    return hunt_lab(c);
}

double feature(const Picture& p, const Size& size, int x, int y, const Square& across, const Square& down)
{
    const auto grey = [&](std::size_t i) { return (p[i][0] + 16.0) / 116.0; };
    return std::hypot(across.at(size, x, y, grey), down.at(size, x, y, grey));
}

} // namespace

std::vector<double> naive_flip(const image::RadianceImage& test, const image::RadianceImage& reference,
                               double ppd)
{
    const Size size{test.width, test.height};
    const Picture a = opponents(test), b = opponents(reference);
    const std::array<Square, 3> eyes = {eye_filter({1.0, 0.0047, 0.0, 1e-5}, ppd),
                                        eye_filter({1.0, 0.0053, 0.0, 1e-5}, ppd),
                                        eye_filter({34.1, 0.04, 13.5, 0.025}, ppd)};
    const double sd = 0.5 * 0.082 * ppd;
    const int radius = static_cast<int>(std::ceil(3.0 * sd));
    const auto g = [sd](int x, int y) { return std::exp(-(x * x + y * y) / (2.0 * sd * sd)); };
    const Square edge_x(radius, [&](int x, int y) { return -x * g(x, y); });
    const Square edge_y(radius, [&](int x, int y) { return -y * g(x, y); });
    const Square point_x(radius, [&](int x, int y) { return (x * x / (sd * sd) - 1.0) * g(x, y); });
    const Square point_y(radius, [&](int x, int y) { return (y * y / (sd * sd) - 1.0) * g(x, y); });
    const double largest = hyab_power(hunt_lab({0.0, 1.0, 0.0}), hunt_lab({0.0, 0.0, 1.0})),
                 limit = 0.4 * largest;
    std::vector<double> result;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double d = hyab_power(seen(a, size, x, y, eyes), seen(b, size, x, y, eyes));
            const double color = d < limit ? 0.95 * d / limit : 0.95 + 0.05 * (d - limit) / (largest - limit);
            const double edges =
                std::fabs(feature(a, size, x, y, edge_x, edge_y) - feature(b, size, x, y, edge_x, edge_y));
            const double points = std::fabs(feature(a, size, x, y, point_x, point_y) -
                                            feature(b, size, x, y, point_x, point_y));
            const double shape = std::sqrt(std::clamp(std::max(edges, points) / std::sqrt(2.0), 0.0, 1.0));
            result.push_back(std::pow(color, 1.0 - shape));
        }
    return result;
}

} // namespace lambent::compare::testing
