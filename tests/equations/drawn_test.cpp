// Directions drawn from lobes against their densities, and the densities against quadrature over all directions.
#include "tests/equations/directions.h"
#include "tests/equations/quadrature.h"
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace lambent::in_double {
namespace {

#include "tests/equations/lobe_hooks.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shading/lobes/drawn.glsl"
#pragma GCC diagnostic pop

} // namespace
} // namespace lambent::in_double

namespace lambent::test {
namespace {

using in_double::density_by_cosine;
using in_double::density_by_facets;
using in_double::density_by_phong;
using in_double::drawn_by_cosine;
using in_double::drawn_by_facets;
using in_double::drawn_by_phong;
using in_double::Metallic;
using in_double::Phong;
using in_double::ShinyPoint;

// A frame that is not the text's.
const vec3 N = from_angles(0.7, 2.1), T = from_angles(0.7 + 0.5 * pi, 2.1),
           B = from_angles(0.5 * pi, 2.1 + 0.5 * pi);

vec3 combined(double x, double y, double z)
{
    return {x * T.x + y * B.x + z * N.x, x * T.y + y * B.y + z * N.y, x * T.z + y * B.z + z * N.z};
}

ShinyPoint seen_at(double NV, double azimuth = 0.9)
{
    const double SV = std::sqrt((1.0 - NV) * (1.0 + NV));
    return {N, combined(SV * std::cos(azimuth), SV * std::sin(azimuth), NV), vec3(0.0), vec3(0.0)};
}

vec3 half_way(vec3 L, vec3 V)
{
    const vec3 sum(L.x + V.x, L.y + V.y, L.z + V.z);
    const double length = std::hypot(sum.x, sum.y, sum.z);
    return {sum.x / length, sum.y / length, sum.z / length};
}

using Draw = std::function<vec3(vec3 point)>;
using Density = std::function<double(vec3 L)>;

// A place on a map of directions: `row` in [0, 1], and an azimuth.
struct Place {
    double row, azimuth;
};

// A direction and how much solid angle it has per row and radian.
struct Patch {
    vec3 direction;
    double area;
};

struct Map {
    std::function<Place(vec3 L)> place;
    std::function<Patch(Place)> patch;
};

constexpr std::size_t rows = 20, columns = 30;

std::vector<double> counted(const Draw& draw, const Map& map, std::uint64_t seed)
{
    Uniform uniform(seed);
    return count(200000, rows * columns, [&] {
        const double xi1 = uniform(), xi2 = uniform();
        const Place at = map.place(draw({xi2, std::cos(2.0 * pi * xi1), std::sin(2.0 * pi * xi1)}));
        return part_of(at.row, rows) * columns + part_of_turn(at.azimuth, columns);
    });
}

std::vector<double> expected(const Density& density, const Map& map)
{
    using Rule = boost::math::quadrature::gauss<double, 15>;
    std::vector<double> cells;
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) {
            const auto along = [&](double row) {
                const auto at = [&](double azimuth) {
                    const Patch p = map.patch({row, azimuth});
                    return p.area > 0.0 ? p.area * density(p.direction) : 0.0;
                };
                const double step = 2.0 * pi / columns, begin = step * static_cast<double>(j);
                return Rule::integrate(at, begin, begin + step);
            };
            cells.push_back(
                Rule::integrate(along, static_cast<double>(i) / rows, static_cast<double>(i + 1) / rows));
        }
    return cells;
}

// The square of the cosine to N: the lower hemisphere has no place, and is not drawn.
Map map_of_cosines()
{
    return {[](vec3 L) -> Place {
                const double z = cosine_between(L, N);
                return {z > 0.0 ? z * z : 2.0, std::atan2(cosine_between(L, B), cosine_between(L, T))};
            },
            [](Place at) -> Patch {
                const double z = std::sqrt(at.row), r = std::sqrt(1.0 - at.row);
                return {combined(r * std::cos(at.azimuth), r * std::sin(at.azimuth), z), 0.5 / z};
            }};
}

// The facets that mirror, by their slopes over alpha: w = 1 / sqrt(1 + r^2), r dr = -dw / w^3. Slopes cover solid angle as
// the cube of the facet's cosine, mirrored directions that of facets as 4 VH.
Map map_of_facets(const ShinyPoint& s, vec2 alpha)
{
    return {[=](vec3 L) -> Place {
                const vec3 H = half_way(L, s.view);
                const double NH = cosine_between(H, N), x = cosine_between(H, T) / (NH * alpha.x),
                             y = cosine_between(H, B) / (NH * alpha.y);
                return {1.0 / std::sqrt(1.0 + x * x + y * y), std::atan2(y, x)};
            },
            [=](Place at) -> Patch {
                const double w = at.row, r = std::sqrt(1.0 - w * w) / w,
                             p = alpha.x * r * std::cos(at.azimuth), q = alpha.y * r * std::sin(at.azimuth),
                             NH = 1.0 / std::sqrt(1.0 + p * p + q * q);
                const vec3 H = combined(NH * p, NH * q, NH), V = s.view;
                const double VH = cosine_between(H, V);
                const vec3 L(2.0 * VH * H.x - V.x, 2.0 * VH * H.y - V.y, 2.0 * VH * H.z - V.z);
                return {L, 4.0 * VH * NH * NH * NH * alpha.x * alpha.y / (w * w * w)};
            }};
}

// The facets that mirror, by the power of their cosine that is uniform. Those that face away from the view mirror as well.
Map map_of_phong(const ShinyPoint& s, double exponent)
{
    return {
        [=](vec3 L) -> Place {
            const vec3 H = half_way(L, s.view);
            const double NH = cosine_between(H, N), x = cosine_between(H, T), y = cosine_between(H, B);
            return {std::pow(std::abs(NH), exponent + 1.0), NH > 0.0 ? std::atan2(y, x) : std::atan2(-y, -x)};
        },
        [=](Place at) -> Patch {
            const double c = std::pow(at.row, 1.0 / (exponent + 1.0)), r = std::sqrt((1.0 - c) * (1.0 + c));
            const vec3 H = combined(r * std::cos(at.azimuth), r * std::sin(at.azimuth), c), V = s.view;
            const double VH = cosine_between(H, V);
            const vec3 L(2.0 * VH * H.x - V.x, 2.0 * VH * H.y - V.y, 2.0 * VH * H.z - V.z);
            return {L, 4.0 * std::abs(VH) / ((exponent + 1.0) * std::pow(c, exponent))};
        }};
}

// Sum of Gauss rules between points that part [low, high] ever finer towards `peak`, and at the kinks.
template <class F>
double integrate_towards(const F& f, double low, double high, double peak, double width,
                         std::vector<double> kinks = {})
{
    std::vector<double> breaks = std::move(kinks);
    breaks.push_back(peak);
    for (double off = 0.5 * width; off < high - low; off *= 2.0)
        breaks.insert(breaks.end(), {peak - off, peak + off});
    breaks.insert(breaks.end(), {low, high});
    std::sort(breaks.begin(), breaks.end());
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        if (breaks[i] >= low && breaks[i + 1] <= high && breaks[i] < breaks[i + 1])
            sum += boost::math::quadrature::gauss<double, 15>::integrate(f, breaks[i], breaks[i + 1]);
    return sum;
}

// Integral over all directions, about the view, from which L is twice as far as the facet half way. The peak is about the
// facet N; beyond the azimuths +-last facets look down, where the density may jump.
double over_sphere(const Density& density, const ShinyPoint& s, double width)
{
    const vec3 V = s.view;
    const double NV = cosine_between(V, N), SV = std::sqrt(std::max((1.0 - NV) * (1.0 + NV), 0.0));
    const vec3 A = SV > 1e-6 ? vec3((N.x - NV * V.x) / SV, (N.y - NV * V.y) / SV, (N.z - NV * V.z) / SV) : T;
    const vec3 C(V.y * A.z - V.z * A.y, V.z * A.x - V.x * A.z, V.x * A.y - V.y * A.x);
    const auto ring = [&](double theta) {
        const double horizon = -NV / (std::tan(0.5 * theta) * std::max(SV, 1e-9));
        const double last = std::acos(std::clamp(horizon, -1.0, 1.0)), z = std::cos(theta);
        const auto at = [&](double phi) {
            const double x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi);
            return density(
                {x * A.x + y * C.x + z * V.x, x * A.y + y * C.y + z * V.y, x * A.z + y * C.z + z * V.z});
        };
        return std::sin(theta) * integrate_towards(at, -pi, pi, 0.0, width, {-last, last});
    };
    // From this angle on some facets look down.
    const double first_down = 2.0 * std::atan2(NV, SV);
    return integrate_towards(ring, 0.0, pi, 2.0 * std::acos(std::min(NV, 1.0)), width, {first_down});
}

double sum_of(const std::vector<double>& cells)
{
    return std::accumulate(cells.begin(), cells.end(), 0.0);
}

// Facets with equal alphas are drawn and tested by the code for such; others need a tangent.
struct Stretch {
    explicit Stretch(int given) { in_double::stretch = given; }
    ~Stretch() { in_double::stretch = 0; }
};

Metallic facets_with(vec2 alpha)
{
    return {vec3(1.0), 1.0, alpha, T, 1.0};
}

Draw draw_of(const Metallic& m, const ShinyPoint& s)
{
    return [=](vec3 point) { return drawn_by_facets(m, s, point); };
}

Density density_of(const Metallic& m, const ShinyPoint& s)
{
    return [=](vec3 L) { return density_by_facets(m, s, L); };
}

Phong phong_with(double exponent)
{
    return {vec3(0.5), vec3(0.5), exponent};
}

constexpr double cosines[] = {0.05, 0.4, 0.8, 1.0};
const vec2 alphas[] = {vec2(0.01), vec2(0.1), vec2(0.5), vec2(1.0), vec2(0.05, 0.4), vec2(1.0, 0.2)};
constexpr double exponents[] = {0.5, 20.0, 5000.0};

TEST(Drawn, ByTheCosineFollowsIt)
{
    const auto draw = [](vec3 point) { return drawn_by_cosine(N, point); };
    const auto density = [](vec3 L) { return density_by_cosine(N, L); };
    EXPECT_TRUE(follows(counted(draw, map_of_cosines(), 1), expected(density, map_of_cosines())));
    EXPECT_NEAR(over_sphere(density, seen_at(0.4), 0.5), 1.0, 1e-4);
    EXPECT_NEAR(density(N), 1.0 / pi, 1e-12);
    EXPECT_EQ(density(vec3(-N.x, -N.y, -N.z)), 0.0);
}

TEST(Drawn, ByFacetsFollowsItsDensity)
{
    std::uint64_t seed = 10;
    for (const vec2& alpha : alphas)
        for (const double NV : cosines) {
            const Stretch stretch(alpha.x < alpha.y || alpha.x > alpha.y);
            const ShinyPoint s = seen_at(NV);
            const Metallic m = facets_with(alpha);
            const Map map = map_of_facets(s, alpha);
            EXPECT_TRUE(follows(counted(draw_of(m, s), map, seed++), expected(density_of(m, s), map)))
                << "NV " << NV << ", alphas " << alpha.x << " " << alpha.y;
        }
}

TEST(Drawn, DensitiesOfFacetsAddUpToOneOverAllDirections)
{
    for (const vec2& alpha : alphas)
        for (const double NV : cosines) {
            const Stretch stretch(alpha.x < alpha.y || alpha.x > alpha.y);
            const ShinyPoint s = seen_at(NV);
            EXPECT_NEAR(over_sphere(density_of(facets_with(alpha), s), s, std::min(alpha.x, alpha.y)), 1.0,
                        2e-4)
                << "NV " << NV << ", alphas " << alpha.x << " " << alpha.y;
        }
}

TEST(Drawn, ByPhongFollowsItsDensity)
{
    std::uint64_t seed = 50;
    for (const double exponent : exponents)
        for (const double NV : cosines) {
            const ShinyPoint s = seen_at(NV);
            const Phong p = phong_with(exponent);
            const Map map = map_of_phong(s, exponent);
            const auto draw = [&](vec3 point) { return drawn_by_phong(p, s, point); };
            const auto density = [&](vec3 L) { return density_by_phong(p, s, L); };
            EXPECT_TRUE(follows(counted(draw, map, seed++), expected(density, map)))
                << "NV " << NV << ", exponent " << exponent;
            EXPECT_NEAR(over_sphere(density, s, 1.0 / std::sqrt(exponent + 2.0)), 1.0, 2e-4)
                << "NV " << NV << ", exponent " << exponent;
        }
}

// Would the tests notice? Densities of a slightly other lobe, and of directions that are drawn another way.
TEST(Drawn, OtherDensitiesAreRefused)
{
    const ShinyPoint s = seen_at(0.4);
    const Metallic m = facets_with(vec2(0.5)), other = facets_with(vec2(0.53));
    const Map map = map_of_facets(s, vec2(0.5));
    EXPECT_FALSE(follows(counted(draw_of(m, s), map, 80), expected(density_of(other, s), map)));
    const Map phong = map_of_phong(s, 20.0);
    const auto draw = [&](vec3 point) { return drawn_by_phong(phong_with(20.0), s, point); };
    const auto density = [&](vec3 L) { return density_by_phong(phong_with(20.5), s, L); };
    EXPECT_FALSE(follows(counted(draw, phong, 81), expected(density, phong)));
    const auto even = [](vec3 L) { return cosine_between(L, N) > 0.0 ? 0.5 / pi : 0.0; };
    const auto by_cosine = [](vec3 point) { return drawn_by_cosine(N, point); };
    EXPECT_FALSE(follows(counted(by_cosine, map_of_cosines(), 82), expected(even, map_of_cosines())));
    EXPECT_NEAR(sum_of(expected(density_of(m, s), map)), 1.0, 1e-3) << "the map covers what is drawn";
}

TEST(Drawn, FramesOfFacetsAreOrthonormal)
{
    for (const int given : {0, 1})
        for (const vec2& alpha : alphas) {
            const Stretch stretch(given);
            const mat3 frame = in_double::facet_frame(facets_with(alpha), N);
            EXPECT_LT(frame_error(frame), 1e-12);
            EXPECT_LT(distance(frame.z, N), 1e-12);
            if (given != 0 && alpha.x != alpha.y) {
                EXPECT_LT(distance(frame.x, T), 1e-12) << "the first alpha is along the tangent";
            }
        }
}

// Y of the primaries' chromaticities and of D65, which are what ITU-R BT.709 fixes: the middle row of the matrix that takes
// R = G = B = 1 to white.
TEST(Drawn, LuminanceIsThatOfThePrimaries)
{
    // Y_i / y_i of the primaries (x, y) scaled so that they add up to white, by Cramer's rule.
    const double x[] = {0.64, 0.30, 0.15}, y[] = {0.33, 0.60, 0.06},
                 white[] = {0.3127 / 0.3290, 1.0, 0.3583 / 0.3290};
    const auto determinant = [](const double(&m)[3][3]) {
        return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    double columns_of[3][3], Y[3];
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            columns_of[k][i] = k == 0 ? x[i] / y[i] : k == 1 ? 1.0 : (1.0 - x[i] - y[i]) / y[i];
    for (int i = 0; i < 3; ++i) {
        double replaced[3][3];
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                replaced[k][j] = j == i ? white[k] : columns_of[k][j];
        Y[i] = determinant(replaced) / determinant(columns_of);
    }
    EXPECT_NEAR(in_double::luminance_of(vec3(1.0, 0.0, 0.0)), Y[0], 1e-4);
    EXPECT_NEAR(in_double::luminance_of(vec3(0.0, 1.0, 0.0)), Y[1], 1e-4);
    EXPECT_NEAR(in_double::luminance_of(vec3(0.0, 0.0, 1.0)), Y[2], 1e-4);
    EXPECT_NEAR(in_double::luminance_of(vec3(3.0)), 3.0, 1e-12);
}

// A disc of the solid angle w and the radius r = acos(1 - w / (2 pi)) about its axis: the mean of theta^2 over two axes.
TEST(Drawn, VarianceOfARayIsThatOfADisc)
{
    for (const double size : {1e-6, 1e-3, 0.05}) {
        const double radius = std::acos(1.0 - size / (2.0 * pi));
        const auto squares = [](double theta) { return theta * theta * std::sin(theta) * 2.0 * pi; };
        const double variance = 0.5 * integrate(squares, 0.0, radius, 1e-15) / size;
        EXPECT_NEAR(in_double::variance_of_ray(1.0 / (4.0 * size), 4.0) / variance, 1.0, 0.01) << size;
    }
    EXPECT_NEAR(in_double::variance_of_ray(2.0, 8.0), 1.0 / 16.0 / (4.0 * pi), 1e-12);
}

} // namespace
} // namespace lambent::test
