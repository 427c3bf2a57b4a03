// Random scenes against the path tracer; `random_light`, a target of the build, compares as many as one likes.
#include "tests/draw/light_agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lambent::draw::testing {
namespace {

// Noise is taken as four standard deviations, which normal noise exceeds once in 16,000 comparisons; what is left is bias, of
// blurs that reach around what stands in the way and of wide cells of the cache.
TEST(RandomLight, IsThatOfThePathTracer)
{
    constexpr double deviations = 4.0, bias = 0.03, bias_of_block = 0.2;
    std::vector<double> off;
    for (std::uint32_t number = 0; number < 40; ++number) {
        const lambent::testing::RandomScene scene = lambent::testing::random_scene(number, 24, 18);
        SCOPED_TRACE(::testing::Message() << number << ": " << scene.words);
        const Agreement found = compare_light(scene, {8, 128, 0});
        if (!(found.mean > 0.0) || found.covered < 30.0)
            continue;
        EXPECT_LT(found.whole.excess(deviations), bias)
            << found.whole.picture << " for " << found.whole.truth << " +- " << found.whole.deviation;
        for (const Block& block : found.blocks)
            EXPECT_LT(block.excess(deviations), bias_of_block) << block.picture << " for " << block.truth;
        off.push_back(found.whole.off());
    }
    ASSERT_GT(off.size(), 30u);
    std::sort(off.begin(), off.end());
    EXPECT_NEAR(off[off.size() / 2], 0.0, 0.003); // no bias that scenes share
}

} // namespace
} // namespace lambent::draw::testing
