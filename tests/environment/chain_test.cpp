// The chain of blurs against exact Gaussians on the sphere and against the panorama's own light.
#include "environment/cube_faces.h"
#include "environment/environment.h"
#include "environment/packed_texel.h"
#include "tests/environment/test_panoramas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace lambent::environment {
namespace {

using testing::normalized;
using testing::Vec;

double texel_value(const CubeChain& chain, int level, int face, int x, int y)
{
    return from_half(chain.halfs()[3 * chain.texel(level, face, x, y)]) * static_cast<double>(chain.scale);
}

// Calls visit(value, direction, solid angle) for every texel of a level.
template <class Visit>
void for_each_texel(const CubeChain& chain, int level, Visit&& visit)
{
    const int n = chain.face_size(level);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const Direction d =
                    cube_direction(face, (2.0 * x + 1.0) / n - 1.0, (2.0 * y + 1.0) / n - 1.0);
                visit(texel_value(chain, level, face, x, y), Vec{d.x, d.y, d.z},
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
        for (double s = -0.95; s < 1.0; s += 0.19)
            for (double t = -0.95; t < 1.0; t += 0.19) {
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

TEST(CubeChain, AConstantStaysConstantEverywhere)
{
    const CubeChain chain = make_chain(testing::panorama_of(128, [](const Vec&) { return 0.75; }));
    for (int level = 0; level < chain.levels; ++level)
        for (int face = 0; face < 6; ++face)
            for (int y = -1; y <= chain.face_size(level); ++y)
                for (int x = -1; x <= chain.face_size(level); ++x)
                    ASSERT_NEAR(texel_value(chain, level, face, x, y), 0.75, 0.75 * 0x1p-9);
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
            EXPECT_NEAR(error, 0.0, 0.01) << "level " << level;
        }
    }
    std::printf("worst error of a level's light: %.2f %%\n", 100.0 * worst);
}

// A sun's picture in each level against the Gaussian that the level stands for.
TEST(CubeChain, ASunBecomesARoundGaussian)
{
    const Vec suns[] = {{0.3, 0.8, -0.4}, {1.0, 1.0, 1.0}, {1.0, 0.98, 0.1}};
    for (const Vec& direction : suns) {
        const Vec sun = normalized(direction);
        const CubeChain chain = make_chain(testing::lone_sun_panorama(1024, sun));
        for (int level = 1; level < chain.levels - 2; ++level) {
            double light = 0.0, second = 0.0;
            Vec centre = {0.0, 0.0, 0.0};
            for_each_texel(chain, level, [&](double value, const Vec& d, double area) {
                const double angle = std::acos(std::min(testing::dot(d, sun), 1.0));
                light += value * area;
                second += value * area * angle * angle;
                for (std::size_t k = 0; k < 3; ++k)
                    centre[k] += value * area * d[k];
            });
            const double deviation = level_one_deviation(chain) * std::exp2(level - 1);
            // A flat Gaussian has a mean square angle of two variances; reading the texels adds a sixth of a texel's.
            const double measured = std::sqrt(second / light / 2.0);
            EXPECT_NEAR(measured / deviation, std::sqrt(5.0 / 6.0), 0.06) << "level " << level;
            const double off = std::acos(std::min(testing::dot(normalized(centre), sun), 1.0));
            EXPECT_LT(off, 0.1 * deviation) << "level " << level;
        }
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
