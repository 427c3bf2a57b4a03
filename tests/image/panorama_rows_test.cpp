// Rows that give the light of their texels.
#include "image/panorama_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::image {
namespace {

constexpr double pi = std::numbers::pi;

// The integral over the sphere of how much a row counts where it is read linearly between `angles`, by quadrature. Beyond a pole
// the row itself goes on, half a turn away: around the pole it counts whole.
double weight_of(const std::vector<double>& angles, std::size_t row)
{
    constexpr int steps = 200000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double a = (i + 0.5) / steps * pi, at = angles[row];
        double counts = 1.0;
        if (a < at && row > 0)
            counts = std::max(1.0 - (at - a) / (at - angles[row - 1]), 0.0);
        if (a > at && row + 1 < angles.size())
            counts = std::max(1.0 - (a - at) / (angles[row + 1] - at), 0.0);
        sum += counts * std::sin(a) * pi / steps;
    }
    return sum;
}

TEST(PanoramaRows, EachGivesTheSolidAngleOfItsTexels)
{
    for (const int height : {1, 2, 3, 4, 5, 8, 17, 64}) {
        const std::vector<double> angles = row_angles(height);
        ASSERT_EQ(angles.size(), static_cast<std::size_t>(height));
        for (std::size_t row = 0; row < angles.size(); ++row) {
            const double top = static_cast<double>(row) * pi / height, bottom = top + pi / height;
            const double texels = std::cos(top) - std::cos(bottom);
            EXPECT_NEAR(weight_of(angles, row), texels, 1e-6 * texels) << height << " rows, row " << row;
        }
    }
}

TEST(PanoramaRows, LieWithinTheirTexelsAndNearlyInTheirMiddles)
{
    for (const int height : {6, 512, 16384}) {
        const std::vector<double> angles = row_angles(height);
        for (std::size_t row = 0; row < angles.size(); ++row) {
            const double off = angles[row] * height / pi - (static_cast<double>(row) + 0.5);
            const double from_pole = static_cast<double>(std::min(row, angles.size() - 1 - row)) + 0.5;
            EXPECT_LT(std::fabs(off), 0.045 / from_pole) << height << " rows, row " << row;
            EXPECT_NEAR(angles[row] + angles[angles.size() - 1 - row], pi, 1e-9);
        }
    }
}

} // namespace
} // namespace lambent::image
