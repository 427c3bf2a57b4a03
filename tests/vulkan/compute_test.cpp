#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

#include <array>

namespace lambent::test {
namespace {

constexpr uint32_t squares[] =
#include "squares.comp.spv.inc"
    ;

TEST(Compute, SquaresNumbers)
{
    const std::unique_ptr<Compute> compute = Compute::open();
    if (!compute) {
        ASSERT_FALSE(vulkan_required()) << "no Vulkan device";
        GTEST_SKIP() << "no Vulkan device";
    }
    std::array<std::vector<float>, 2> buffers;
    for (int i = 0; i < 384; i++)
        buffers[0].push_back(static_cast<float>(i));
    buffers[1].assign(384, -1.0f);
    for (int round = 0; round < 2; round++) // twice: a run leaves nothing behind
        compute->run(squares, buffers, {3, 2, 1});
    for (int i = 0; i < 384; i++) {
        ASSERT_EQ(buffers[1][static_cast<size_t>(i)], static_cast<float>(i * i));
        ASSERT_EQ(buffers[0][static_cast<size_t>(i)], static_cast<float>(i));
    }
    EXPECT_EQ(compute->complaints(), std::vector<std::string>());
}

// The layer must be able to fail a test: more groups than any device allows, of which none runs.
TEST(Compute, ValidationComplainsOfWrongUse)
{
    const std::unique_ptr<Compute> compute = Compute::open();
    if (!compute) {
        ASSERT_FALSE(vulkan_required()) << "no Vulkan device";
        GTEST_SKIP() << "no Vulkan device";
    }
    if (!compute->validated())
        GTEST_SKIP() << "no Vulkan validation layer";
    std::array<std::vector<float>, 2> buffers = {{{1.0f}, {1.0f}}};
    compute->run(squares, buffers, {0, 0xffffffff, 1});
    EXPECT_FALSE(compute->complaints().empty());
}

} // namespace
} // namespace lambent::test
