// Where and at which level textures are read, in double, against closed forms.
#include "tests/equations/directions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::in_double {
namespace {

#include "shading/surface/texture.glsl"

} // namespace
} // namespace lambent::in_double

namespace lambent::test {
namespace {

using in_double::texture_footprint;
using in_double::TextureFootprint;
using in_double::vec2;

// A pixel that covers so many texels of a 512x256 texture along each axis.
TextureFootprint covering(double along_u, double along_v)
{
    return texture_footprint({vec2(0.3, 0.7), vec2(along_u / 512.0, 0.0), vec2(0.0, along_v / 256.0)},
                             vec2(512.0, 256.0), 9.0);
}

TEST(TextureFootprint, SquaresAreReadOnceAtTheLevelOfTheirSide)
{
    EXPECT_NEAR(covering(1.0, 1.0).level, 0.0, 1e-12);
    EXPECT_NEAR(covering(4.0, 4.0).level, 2.0, 1e-12);
    EXPECT_NEAR(covering(4.0, 4.0).ratio, 1.0, 1e-12);
    EXPECT_EQ(covering(0.1, 0.1).level, 0.0);
    EXPECT_EQ(covering(0.1, 0.1).ratio, 1.0);
    EXPECT_NEAR(covering(0.5, 0.5).longer2, 0.25, 1e-12);
    EXPECT_EQ(covering(1e5, 1e5).level, 9.0); // the last there is
}

TEST(TextureFootprint, LongOnesAreReadAlongTheirAxis)
{
    const TextureFootprint wide = covering(4.0, 1.0), high = covering(2.0, 16.0),
                           long_one = covering(100.0, 1.0);
    EXPECT_NEAR(wide.level, 0.0, 1e-12);
    EXPECT_NEAR(wide.ratio, 4.0, 1e-12);
    EXPECT_NEAR(wide.axis.x, 4.0 / 512.0, 1e-15);
    EXPECT_EQ(wide.axis.y, 0.0);
    EXPECT_NEAR(high.level, 1.0, 1e-12);
    EXPECT_NEAR(high.ratio, 8.0, 1e-12);
    EXPECT_NEAR(high.axis.y, 16.0 / 256.0, 1e-15);
    EXPECT_NEAR(long_one.ratio, 8.0, 1e-12); // no more than 8 reads, of a coarser level
    EXPECT_NEAR(long_one.level, std::log2(100.0 / 8.0), 1e-12);
}

TEST(TextureFootprint, InfiniteOnesAreReadOnceAtTheLastLevel)
{
    const TextureFootprint f = covering(1e30, 1e30);
    EXPECT_EQ(f.level, 9.0);
    EXPECT_EQ(f.ratio, 1.0);
}

TEST(TextureFootprint, CoordinatesRepeatAndMirror)
{
    for (const double x : {-2.75, -1.5, -0.25, 0.0, 0.4, 1.25, 3.5}) {
        const double whole = std::floor(x), part = x - whole;
        EXPECT_NEAR(in_double::repeated(x), part, 1e-15);
        const bool odd = std::fmod(std::fabs(whole), 2.0) == 1.0;
        EXPECT_NEAR(in_double::repeated_mirrored(x), odd ? 1.0 - part : part, 1e-15) << x;
    }
    EXPECT_NEAR(in_double::snapped(0.26, 8.0), 2.5 / 8.0, 1e-15);
    EXPECT_NEAR(in_double::snapped(0.99, 8.0), 7.5 / 8.0, 1e-15);
}

// The nearer of two levels; between them, Vulkan's ceil(level + 0.5) - 1.
TEST(TextureFootprint, OneLevelIsTheNearest)
{
    for (const double level : {0.0, 0.2, 0.49, 0.5, 0.51, 1.0, 1.4, 1.5, 2.7, 9.0})
        EXPECT_EQ(in_double::nearest_level(level), std::ceil(level + 0.5) - 1.0) << level;
}

} // namespace
} // namespace lambent::test
