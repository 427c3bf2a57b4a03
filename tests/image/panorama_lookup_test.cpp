// Panoramas between their texels: round the columns and across the poles.
#include "image/panorama_lookup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace lambent::image {
namespace {

constexpr double pi = std::numbers::pi;

using Direction = std::array<double, 3>;

Direction direction_of(double u, double v)
{
    const double phi = (u - 0.5) * 2.0 * pi, theta = v * pi;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

// A picture of one number a texel.
struct Picture {
    int width, height;
    std::vector<double> values;
    PanoramaRows rows{height};

    std::array<double, 3> texel(int x, int y) const
    {
        EXPECT_TRUE(x >= 0 && x < width && y >= 0 && y < height) << x << ", " << y;
        const double value = values[static_cast<std::size_t>(y * width + x)];
        return {value, 2.0 * value, -value};
    }
    double at(double u, double v) const
    {
        const std::array<double, 3> rgb = bilinear(columns_around(u, width), rows.around(v), width, height,
                                                   [this](int x, int y) { return texel(x, y); });
        EXPECT_NEAR(rgb[1], 2.0 * rgb[0], 1e-12);
        EXPECT_NEAR(rgb[2], -rgb[0], 1e-12);
        return rgb[0];
    }
};

TEST(PanoramaLookup, TexelsBeyondTheEdges)
{
    const auto expect = [](const PanoramaTexel& found, int x, int y) {
        EXPECT_EQ(found.x, x);
        EXPECT_EQ(found.y, y);
    };
    expect(texel_across(3, 2, 8, 4), 3, 2);
    expect(texel_across(-1, 2, 8, 4), 7, 2);
    expect(texel_across(8, 2, 8, 4), 0, 2);
    expect(texel_across(-17, 0, 8, 4), 7, 0);
    expect(texel_across(1, -1, 8, 4), 5, 0);
    expect(texel_across(6, -2, 8, 4), 2, 1);
    expect(texel_across(8, 4, 8, 4), 4, 3);
    expect(texel_across(-1, 5, 8, 4), 3, 2);
    expect(texel_across(0, -1, 2, 1), 1, 0);
    expect(texel_across(0, 1, 2, 1), 1, 0);
    // Of an odd number of columns each is once beyond the pole.
    for (int x = 0; x < 5; ++x)
        expect(texel_across(x, -1, 5, 3), (x + 2) % 5, 0);
}

TEST(PanoramaLookup, NeighboursAreOnEitherSide)
{
    for (const int height : {1, 2, 3, 8, 500}) {
        const std::vector<double> angles = row_angles(height);
        const PanoramaRows rows(height);
        // The row beyond a pole is as far from it as the first and the last.
        const auto place = [&](int row) {
            return (row < 0         ? -angles.front()
                    : row >= height ? 2.0 * pi - angles.back()
                                    : angles[static_cast<std::size_t>(row)]) /
                   pi;
        };
        for (int i = 0; i <= 1000; ++i) {
            const double v = i / 1000.0;
            const Neighbours at = rows.around(v);
            ASSERT_EQ(at.second, at.first + 1);
            EXPECT_TRUE(at.first >= -1 && at.second <= height && at.share >= 0.0 && at.share <= 1.0);
            EXPECT_NEAR(place(at.first) + at.share * (place(at.second) - place(at.first)), v, 1e-12);
        }
    }
    for (const int width : {1, 2, 7, 100})
        for (int i = 0; i <= 1000; ++i) {
            const Neighbours at = columns_around(i / 1000.0, width);
            ASSERT_EQ(at.second, at.first + 1);
            EXPECT_TRUE(at.first >= -1 && at.second <= width && at.share >= 0.0 && at.share < 1.0);
            EXPECT_NEAR(at.first + 0.5 + at.share, i / 1000.0 * width, 1e-9);
        }
}

// Light that is linear in the direction stays so, near the poles too.
TEST(PanoramaLookup, ALinearFunctionOfDirection)
{
    const int width = 240, height = 120;
    const std::vector<double> angles = row_angles(height);
    const auto expected = [](const Direction& d) { return 3.0 + d[0] - 0.5 * d[1] + 2.0 * d[2]; };
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.values.push_back(
                expected(direction_of((x + 0.5) / width, angles[static_cast<std::size_t>(y)] / pi)));
    const double step = pi / height;
    for (int i = 0; i <= 1200; ++i)
        for (int j = 0; j < 50; ++j) {
            const double u = (j + 0.1) / 50, v = i / 1200.0;
            // Second order in the step along both axes: a step's square over eight, times the largest second derivative.
            EXPECT_NEAR(picture.at(u, v), expected(direction_of(u, v)), 3.0 * step * step / 4.0)
                << u << ", " << v;
        }
}

// Every texel gives its value times its solid angle: those of the pole's rows on both sides of it.
TEST(PanoramaLookup, EachTexelKeepsItsLight)
{
    for (const auto& [width, height] : {std::pair(8, 4), {5, 3}, {2, 1}})
        for (int y = 0; y < height; ++y) {
            Picture picture{width, height, std::vector<double>(static_cast<std::size_t>(width * height))};
            picture.values[static_cast<std::size_t>(y * width + 1)] = 1.0;
            constexpr int steps = 2000, turns = 40;
            double sum = 0.0;
            for (int i = 0; i < steps; ++i)
                for (int j = 0; j < turns * width; ++j)
                    sum += picture.at((j + 0.5) / (turns * width), (i + 0.5) / steps) *
                           texel_solid_angle(turns * width, steps, i);
            EXPECT_NEAR(sum / texel_solid_angle(width, height, y), 1.0, 1e-5) << width << ", row " << y;
        }
}

TEST(PanoramaLookup, ColumnsAndSolidAngles)
{
    EXPECT_NEAR(column_azimuth(4.0, 8), 0.0, 1e-15); // +X in the middle
    EXPECT_NEAR(column_azimuth(6.0, 8), 0.5 * pi, 1e-15);
    EXPECT_NEAR(column_azimuth(0.0, 8), -pi, 1e-15);
    double sum = 0.0;
    for (int y = 0; y < 7; ++y)
        sum += 9.0 * texel_solid_angle(9, 7, y);
    EXPECT_NEAR(sum, 4.0 * pi, 1e-12);
}

} // namespace
} // namespace lambent::image
