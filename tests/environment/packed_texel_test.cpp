// Rows of texels, packed in lanes.
#include "environment/panorama/pack_row.h"
#include "environment/panorama/packed_texel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace lambent::environment {
namespace {

TEST(PackedTexel, RowsArePackedAsSingleTexelsAre)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> exponent(-30.0f, 16.5f);
    for (int count : {1, 7, 16, 31, 100}) {
        std::vector<float> rgb(static_cast<std::size_t>(3 * count));
        for (float& v : rgb)
            v = random() % 8 == 0 ? 0.0f : std::exp2(exponent(random));
        rgb[0] = 3.5f; // and a shade less than half a step beside it
        rgb[1] = std::nextafter(0x1p-8f, 0.0f);
        std::vector<std::uint32_t> texels(static_cast<std::size_t>(count));
        pack_row(rgb.data(), count, 0.5f, texels.data());
        for (std::size_t i = 0; i < texels.size(); ++i)
            ASSERT_EQ(texels[i],
                      pack_rgb9e5(rgb[3 * i] * 0.5f, rgb[3 * i + 1] * 0.5f, rgb[3 * i + 2] * 0.5f));
    }
}

} // namespace
} // namespace lambent::environment
