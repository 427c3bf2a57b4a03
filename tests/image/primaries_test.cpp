// Colours against published matrices.
#include "image/openexr/primaries.h"

#include <gtest/gtest.h>

#include <limits>

namespace lambent::image {
namespace {

void expect_matrix(const Primaries& primaries, const ColourMatrix& expected, double tolerance)
{
    const auto matrix = to_rec709(primaries);
    ASSERT_TRUE(matrix);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_NEAR((*matrix)[i][j], expected[i][j], tolerance) << i << "," << j;
}

TEST(Primaries, Rec709StaysAsItIs)
{
    expect_matrix({}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1e-12);
    EXPECT_TRUE(is_identity(*to_rec709({})));
}

// ACES2065-1 to Rec. 709 by Bradford. [as published with the ACES configuration of OpenColorIO]
TEST(Primaries, Aces)
{
    expect_matrix(
        {{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, {0.32168, 0.33767}},
        {{{2.52169, -1.13413, -0.38756}, {-0.27648, 1.37272, -0.09624}, {-0.01538, -0.15298, 1.16835}}},
        2e-4);
}

// Rec. 2020 to Rec. 709, whose white is the same. [ITU-R BT.2087-0, M2]
TEST(Primaries, Rec2020)
{
    const Primaries rec2020 = {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
    expect_matrix(rec2020,
                  {{{1.6605, -0.5876, -0.0728}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1187}}},
                  1e-4);
    EXPECT_FALSE(is_identity(*to_rec709(rec2020)));
}

// The primaries of sRGB as colour profiles tell them, adapted to D50 by the same transform: nothing changes.
TEST(Primaries, Rec709AdaptedToD50)
{
    EXPECT_TRUE(is_identity(*to_rec709(
        {{0.648447, 0.330877}, {0.321187, 0.597894}, {0.155901, 0.066056}, {0.345708, 0.358541}})));
}

// OpenEXR's mark for XYZ: the values are XYZ under D65 already. [IEC 61966-2-1, the inverse matrix]
TEST(Primaries, Xyz)
{
    expect_matrix({{1.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}, {1.0 / 3.0, 1.0 / 3.0}},
                  {{{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}}}, 5e-4);
}

TEST(Primaries, WithoutSense)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 far = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(to_rec709({{0.3, 0.3}, {0.4, 0.4}, {0.5, 0.5}, {0.3, 0.3}}));
    EXPECT_FALSE(to_rec709({{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3, 0.0}}));
    EXPECT_FALSE(to_rec709({{nan, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3, 0.3}}));
    EXPECT_FALSE(to_rec709({{0.64, far}, {0.3, 0.6}, {0.15, 0.06}, {0.3, 0.3}}));
    EXPECT_FALSE(to_rec709({}) == std::nullopt);
}

} // namespace
} // namespace lambent::image
