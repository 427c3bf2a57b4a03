// The kitchen that is part of the program against the scene it was traced from.
#include "kitchen/trace_kitchen.h"
#include "environment/builtin/builtin.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent {
namespace {

constexpr int width = 64, height = 32, cell = 8;

// Mean luminance of a cell of pixels.
double light(const image::RadianceImage& image, int column, int row)
{
    double sum = 0.0;
    for (int y = row * cell; y < (row + 1) * cell; ++y)
        for (int x = column * cell; x < (column + 1) * cell; ++x)
            for (int c = 0; c < 3; ++c)
                sum += static_cast<double>(image.pixel(x, y)[c]) / (3.0 * cell * cell);
    return sum;
}

// Traced small, without its noise taken out: each part of the room is as bright as in the stored picture, within a sixth
// (the noise of so few paths; that the stored one is smoothed, and stored with some loss, is less), the whole within 3 %.
TEST(KitchenPanorama, IsThePictureOfItsScene)
{
    KitchenTrace trace;
    trace.width = width, trace.height = height;
    trace.samples = 256;
    trace.smooth = false;
    const image::RadianceImage traced = trace_kitchen(trace).radiance;
    const image::RadianceImage stored = environment::make_builtin("kitchen", {.width = width});
    double sum_traced = 0.0, sum_stored = 0.0;
    for (int row = 0; row < height / cell; ++row)
        for (int column = 0; column < width / cell; ++column) {
            const double expected = light(traced, column, row), found = light(stored, column, row);
            EXPECT_NEAR(found / expected, 1.0, 1.0 / 6.0) << column << ", " << row;
            sum_traced += expected;
            sum_stored += found;
        }
    EXPECT_NEAR(sum_stored / sum_traced, 1.0, 0.03);
}

// Ceiling, window, island, floor: nothing black, the window the brightest, white walls warm rather than blue.
TEST(KitchenPanorama, IsALitRoom)
{
    const image::RadianceImage stored = environment::make_builtin("kitchen", {.width = width});
    double least = 1e9, most = 0.0;
    for (int row = 0; row < height / cell; ++row)
        for (int column = 0; column < width / cell; ++column) {
            least = std::min(least, light(stored, column, row));
            most = std::max(most, light(stored, column, row));
        }
    EXPECT_GT(least, 0.02);
    EXPECT_GT(most, 4.0 * least);
    EXPECT_GT(light(stored, 4, 1), light(stored, 2, 0)); // the window towards +X against the ceiling
}

} // namespace
} // namespace lambent
