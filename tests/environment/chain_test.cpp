// The chain of blurs against exact Gaussians on the sphere and against the panorama's own light.
#include "environment/chain/cube_faces.h"
#include "environment/chain/make_chain.h"
#include "environment/environment.h"
#include "environment/chain/kernels.h"
#include "environment/panorama/packed_texel.h"
#include "tests/environment/test_panoramas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <functional>

namespace lambent::environment {
namespace {

using testing::normalized;
using testing::Vec;

// `texel` is an index as CubeChain::texel gives it.
double texel_value(const CubeChain& chain, std::size_t texel, std::size_t channel = 0)
{
    return from_half(chain.halfs()[3 * texel + channel]) * static_cast<double>(chain.scale);
}

// Calls visit(value, direction, solid angle) for every texel of a level.
template <class Visit>
void for_each_texel(const CubeChain& chain, int level, Visit&& visit, std::size_t channel = 0)
{
    const int n = chain.face_size(level);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const Direction d =
                    cube_direction(face, (2.0 * x + 1.0) / n - 1.0, (2.0 * y + 1.0) / n - 1.0);
                visit(texel_value(chain, chain.texel(level, face, x, y), channel), Vec{d.x, d.y, d.z},
                      cube_texel_solid_angle(n, x, y));
            }
}

double light_of_level(const CubeChain& chain, int level)
{
    double sum = 0.0;
    for_each_texel(chain, level, [&](double value, const Vec&, double area) { sum += value * area; });
    return sum;
}

TEST(CubeFaces, SixAxes)
{
    const Vec axes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < 6; ++face) {
        const Direction d = cube_direction(face, 0.0, 0.0);
        EXPECT_NEAR(testing::dot({d.x, d.y, d.z}, axes[face]), 1.0, 1e-12);
        EXPECT_EQ(cube_position(d).face, face);
    }
}

TEST(CubeFaces, DirectionAndPositionAreInverse)
{
    for (int face = 0; face < 6; ++face)
        for (int i = -5; i <= 5; ++i)
            for (int j = -5; j <= 5; ++j) {
                const double s = 0.19 * i, t = 0.19 * j;
                const FacePosition p = cube_position(cube_direction(face, s, t));
                ASSERT_EQ(p.face, face);
                ASSERT_NEAR(p.s, s, 1e-12);
                ASSERT_NEAR(p.t, t, 1e-12);
            }
}

TEST(CubeChain, LevelsDoNotOverlap)
{
    CubeChain chain;
    chain.allocate(7, 7);
    for (int level = 0; level < chain.levels; ++level) {
        const int n = chain.face_size(level);
        const std::size_t last = chain.texel(level, 5, n, n);
        const std::size_t next = level > 0 ? chain.texel(level - 1, 0, -1, -1) : chain.end();
        EXPECT_LT(last, next);
    }
}

// A tap set that is off centre moves all light, in each face's own directions.
TEST(GaussianTaps, AreCentredAndAlikeInAllDirections)
{
    for (const int rings : {4, 5})
        for (const float deviation : {0.001f, 0.1f, 0.6f}) {
            const GaussianTaps taps = gaussian_taps(rings, deviation);
            const double count = static_cast<double>(taps.x.size()),
                         v = std::pow(static_cast<double>(deviation), 2);
            double x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0, square = 0.0;
            for (std::size_t i = 0; i < taps.x.size(); ++i) {
                const double a = taps.x[i], b = taps.y[i], c = taps.z[i];
                x += a / count, y += b / count;
                xx += a * a / count, yy += b * b / count, xy += a * b / count;
                square += std::pow(std::atan2(std::hypot(a, b), c), 2) / count;
            }
            EXPECT_NEAR(x / static_cast<double>(deviation), 0.0, 1e-6);
            EXPECT_NEAR(y / static_cast<double>(deviation), 0.0, 1e-6);
            EXPECT_NEAR((xx - yy) / v, 0.0, 1e-6);
            EXPECT_NEAR(xy / v, 0.0, 1e-6);
            EXPECT_NEAR(square / v, 2.0, 1e-5); // one variance along each axis
        }
}

// At an edge both faces read the same, and at a corner all three.
TEST(CubeChain, LookupsAreContinuousAcrossEdgesAndCorners)
{
    CubeChain chain;
    chain.allocate(2, 1);
    const int n = chain.face_size(0);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                for (std::size_t k = 0; k < 3; ++k)
                    chain.halfs()[3 * chain.texel(0, face, x, y) + k] = to_half(
                        static_cast<float>(60 + (37 * face + 11 * x + 5 * y) % 16)); // as half floats to 1/16
    fill_borders(chain, 0);
    const auto bilinear = [&](int face, double s, double t) {
        const double x = (s * 0.5 + 0.5) * n - 0.5, y = (t * 0.5 + 0.5) * n - 0.5;
        const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
        const double fx = x - i, fy = y - j;
        const auto at = [&](int a, int b) { return texel_value(chain, chain.texel(0, face, a, b)); };
        return (at(i, j) * (1 - fx) + at(i + 1, j) * fx) * (1 - fy) +
               (at(i, j + 1) * (1 - fx) + at(i + 1, j + 1) * fx) * fy;
    };
    int compared = 0;
    for (int a = 0; a < 6; ++a)
        for (const double edge : {-1.0, 1.0})
            for (int i = 0; i <= 40; ++i)
                for (const bool upright : {false, true}) {
                    const double along = i / 20.0 - 1.0, s = upright ? edge : along,
                                 t = upright ? along : edge;
                    const Direction d = cube_direction(a, s, t);
                    const double axes[3] = {d.x, d.y, d.z},
                                 most = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
                    for (int b = 0; b < 6; ++b) {
                        // The faces on which the direction is at the edge, too.
                        if (b == a || axes[b / 2] * (b % 2 ? -1.0 : 1.0) < most * (1.0 - 1e-9))
                            continue;
                        const double u[6][2] = {{-d.z, -d.y}, {d.z, -d.y}, {d.x, d.z},
                                                {d.x, -d.z},  {d.x, -d.y}, {-d.x, -d.y}};
                        EXPECT_NEAR(bilinear(a, s, t), bilinear(b, u[b][0] / most, u[b][1] / most), 0.07);
                        ++compared;
                    }
                }
    EXPECT_GE(compared, 6 * 4 * 41);
}

TEST(CubeChain, AConstantStaysConstantEverywhere)
{
    const CubeChain chain = make_chain(testing::panorama_of(128, [](const Vec&) { return 0.75; }));
    for (int level = 0; level < chain.levels; ++level)
        for (int face = 0; face < 6; ++face)
            for (int y = -1; y <= chain.face_size(level); ++y)
                for (int x = -1; x <= chain.face_size(level); ++x)
                    ASSERT_NEAR(texel_value(chain, chain.texel(level, face, x, y)), 0.75, 0.75 * 0x1p-9);
}

TEST(CubeChain, KeepsTheLightOfASun)
{
    const Vec suns[] = {
        {0.3, 0.8, -0.4}, {1.0, 1.0, 1.0}, {0.01, 1.0, 0.02}, {-1.0, 0.05, 0.02}, {0.0, 0.7, 0.7}};
    double worst = 0.0;
    for (const Vec& sun : suns) {
        const Panorama p = testing::sunny_panorama(1024, normalized(sun));
        const CubeChain chain = make_chain(p);
        const double light = testing::integral(p, [](const Vec&) { return 1.0; });
        for (int level = 1; level < chain.levels; ++level) {
            const double error = light_of_level(chain, level) / light - 1.0;
            worst = std::max(worst, std::fabs(error));
            EXPECT_NEAR(error, 0.0, 1e-3) << "level " << level;
        }
    }
    std::printf("worst error of a level's light: %.2f %%\n", 100.0 * worst);
}

// What a level is without is in the lamps, and only that: no more than 16 of them, and none where nothing is small.
TEST(CubeChain, LampsApartAreTheLightThatCoarseLevelsAreWithout)
{
    const Panorama p = testing::sunny_panorama(1024, normalized({0.3, 0.8, -0.4}));
    const Blurs blurs = make_blurs(p);
    ASSERT_GT(blurs.lamps.lamps.size(), 0u);
    ASSERT_LE(blurs.lamps.lamps.size(), 16u);
    double apart = 0.0;
    for (const Lamp& lamp : blurs.lamps.lamps)
        apart += lamp.light[1];
    const double light = testing::integral(p, [](const Vec&) { return 1.0; });
    EXPECT_GT(apart, 0.1 * light);
    ASSERT_LT(blurs.lamps.last_level + 1, blurs.chain.levels);
    for (int level = 1; level < blurs.chain.levels; ++level) {
        const double held = light_of_level(blurs.chain, level);
        EXPECT_NEAR((held + (level > blurs.lamps.last_level ? apart : 0.0)) / light, 1.0, 1e-3) << level;
    }
    EXPECT_TRUE(make_blurs(testing::panorama_of(128, [](const Vec&) { return 0.75; })).lamps.lamps.empty());
}

// Where light lies about a direction, in angles along two tangents.
struct Spread {
    double light = 0.0, xx = 0.0, yy = 0.0, xy = 0.0, fourth = 0.0; // means but for the light
    Vec centre = {0.0, 0.0, 0.0};                                   // not of unit length
};

Spread spread_about(const Vec& pole, const CubeChain& chain, int level)
{
    const Vec aside = normalized({pole[1], -pole[0], 0.0}),
              up = {pole[1] * aside[2] - pole[2] * aside[1], pole[2] * aside[0] - pole[0] * aside[2],
                    pole[0] * aside[1] - pole[1] * aside[0]};
    Spread sum;
    for_each_texel(chain, level, [&](double value, const Vec& d, double area) {
        const double x = testing::dot(d, aside), y = testing::dot(d, up), sine = std::hypot(x, y);
        const double angle = std::atan2(sine, testing::dot(d, pole)),
                     stretch = sine > 0.0 ? angle / sine : 1.0;
        const double light = value * area, ax = x * stretch, ay = y * stretch;
        sum.light += light;
        sum.xx += light * ax * ax;
        sum.yy += light * ay * ay;
        sum.xy += light * ax * ay;
        sum.fourth += light * std::pow(angle, 4);
        for (std::size_t k = 0; k < 3; ++k)
            sum.centre[k] += light * d[k];
    });
    for (double* mean : {&sum.xx, &sum.yy, &sum.xy, &sum.fourth})
        *mean /= sum.light;
    return sum;
}

// A sun's picture in each level against the Gaussian that the level stands for.
TEST(CubeChain, ASunBecomesARoundGaussian)
{
    const Vec suns[] = {{0.3, 0.8, -0.4}, {1.0, 1.0, 1.0}, {1.0, 0.98, 0.1}};
    for (const Vec& direction : suns) {
        const Vec sun = normalized(direction);
        const CubeChain chain = make_chain(testing::lone_sun_panorama(1024, sun));
        for (int level = 1; level < chain.levels - 2; ++level) {
            const Spread spread = spread_about(sun, chain, level);
            const double deviation = level_one_deviation(chain) * std::exp2(level - 1);
            // A flat Gaussian has a mean square angle of two variances; reading the texels adds a sixth of a texel's.
            const double square = spread.xx + spread.yy, measured = std::sqrt(square / 2.0);
            EXPECT_NEAR(measured / deviation, std::sqrt(5.0 / 6.0), 0.06) << "level " << level;
            const double off = std::acos(std::min(testing::dot(normalized(spread.centre), sun), 1.0));
            EXPECT_LT(off, 0.1 * deviation) << "level " << level;
            // As wide one way as any other, and of a Gaussian's shape: a disc would have 0.67, a square 0.7.
            EXPECT_NEAR(spread.xx / square, 0.5, 0.015) << "level " << level;
            EXPECT_NEAR(spread.xy / square, 0.0, 0.015) << "level " << level;
            EXPECT_NEAR(spread.fourth / (2.0 * square * square), 1.0, 0.05) << "level " << level;
        }
    }
}

// The real part of ((u + i v).d)^l, u and v perpendicular: a harmonic of order l, and no axis is like another.
double harmonic(int l, const Vec& u, const Vec& v, const Vec& d)
{
    return std::pow(std::complex<double>(testing::dot(u, d), testing::dot(v, d)), l).real();
}

// How much of a harmonic of amplitude 0.8 around 1 is left in a level, and what else there is.
struct Left {
    double harmonic, rest; // shares of what it was, root mean square
};

Left left_of(const std::function<double(const Vec&)>& shape, const CubeChain& chain, int level,
             std::size_t channel)
{
    double product = 0.0, square = 0.0, all = 0.0;
    for_each_texel(
        chain, level,
        [&](double value, const Vec& d, double area) {
            const double change = (value - 1.0) / 0.8, y = shape(d);
            product += change * y * area;
            square += y * y * area;
            all += change * change * area;
        },
        channel);
    const double share = product / square;
    return {share, std::sqrt(std::max(all / square - share * share, 0.0))};
}

// A Gaussian blur takes exp(-l (l + 1) variance / 2) of a harmonic and leaves it one. [heat on the sphere] A level as
// stored has five sixths of its variance; reading it adds the sixth. Another harmonic in each channel.
TEST(CubeChain, HarmonicsShrinkAsUnderAGaussian)
{
    const Vec u = normalized({0.5, 0.7, -0.3}), v = normalized({0.9, -0.3, 0.8});
    ASSERT_NEAR(testing::dot(u, v), 0.0, 1e-12);
    constexpr int orders[3] = {2, 6, 3};
    const CubeChain chain = make_chain(testing::coloured_panorama_of(256, [&](const Vec& d) {
        return Vec{1.0 + 0.8 * harmonic(orders[0], u, v, d), 1.0 + 0.8 * harmonic(orders[1], u, v, d),
                   1.0 + 0.8 * harmonic(orders[2], u, v, d)};
    }));
    for (std::size_t channel = 0; channel < 3; ++channel)
        for (int level = 0; chain.face_size(level) >= 4; ++level) {
            const int l = orders[channel];
            const Left left =
                left_of([&](const Vec& d) { return harmonic(l, u, v, d); }, chain, level, channel);
            const double deviation = level == 0 ? 0.0 : level_one_deviation(chain) * std::exp2(level - 1);
            const double wanted = std::exp(-0.5 * l * (l + 1) * 5.0 / 6.0 * deviation * deviation);
            EXPECT_NEAR(left.harmonic, wanted, 0.012) << "order " << l << ", level " << level;
            EXPECT_LT(left.rest, 0.04) << "order " << l << ", level " << level;
        }
}

TEST(MipChain, HalvesDownToOneRow)
{
    const std::vector<Panorama> chain =
        mip_chain(testing::panorama_of(64, [](const Vec& d) { return 1.0 + d[0]; }));
    ASSERT_EQ(chain.size(), 6u);
    EXPECT_EQ(chain.back().height, 1);
    EXPECT_EQ(chain.back().width, 2);
    EXPECT_NEAR(testing::integral(chain[4], [](const Vec&) { return 1.0; }), 4.0 * std::numbers::pi, 0.05);
}

// Light stays where it comes from, in each channel: the integral of (b.d) d over the sphere is 4 pi / 3 b.
void expect_coloured_moments(const Panorama& p, double bound)
{
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Vec moment = testing::moment(p, channel);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double wanted = 4.0 / 3.0 * std::numbers::pi * testing::coloured_light[channel].first[axis];
            EXPECT_NEAR(moment[axis], wanted, bound)
                << p.width << " columns, channel " << channel << ", axis " << axis;
        }
    }
}

TEST(MipChain, NeitherMirrorsNorShifts)
{
    const std::vector<Panorama> chain = mip_chain(testing::coloured_panorama(64));
    for (std::size_t level = 0; level < 3; ++level)
        expect_coloured_moments(chain[level], 0.05);
    // A size that has to be enlarged to 128x64 first.
    expect_coloured_moments(mip_chain(testing::coloured_panorama(100)).front(), 0.02);
}

TEST(MipChain, OddSizesAreBroughtToPowersOfTwo)
{
    image::RadianceImage image{100, 50, 3, std::vector<float>(100 * 50 * 3, 0.5f)};
    const std::vector<Panorama> chain = mip_chain(make_panorama(image));
    EXPECT_EQ(chain.front().width, 128);
    EXPECT_EQ(chain.front().height, 64);
    EXPECT_EQ(chain.front().radiance(77, 12).g, 0.5f);
}

} // namespace
} // namespace lambent::environment
