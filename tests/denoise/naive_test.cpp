// The filter against itself written plainly in double.
#include "tests/denoise/naive_filter.h"
#include "tests/denoise/pictures.h"
#include "tests/support/each_instruction_set.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::denoise::test {
namespace {

class AgainstNaive : public lambent::test::EachInstructionSet {};
LAMBENT_EACH_INSTRUCTION_SET(AgainstNaive);

// Where two candidates are equally good, rounding may decide for the other: at one pixel in a thousand, so no more than
// the blended neighbourhoods of that many may be off.
void expect_like(const FilteredLight& found, const NaiveResult& naive)
{
    int off = 0, values = 0;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < naive.light[c].size(); ++i, ++values)
            off += std::fabs(static_cast<double>(found.light[c][i]) - naive.light[c][i]) > 2e-5 ||
                   std::fabs(static_cast<double>(found.gap[c][i]) - naive.gap[c][i]) > 2e-5;
    EXPECT_LE(off, values / 100);
}

TEST_P(AgainstNaive, PicturesAgree)
{
    const Settings settings[] = {{1.0f, 2.0f}, {0.2f, 1.0f}};
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
        const Picture picture = make_mixture(83, 57, seed);
        const Settings& set = settings[seed - 1];
        const Filtered found = filter_light(picture, set);
        expect_like(found.diffuse, naive_filter(picture, picture.diffuse, false, set));
        expect_like(found.specular, naive_filter(picture, picture.specular, true, set));
    }
}

// The settings and the guides do something: the plain version with another of each differs at many pixels.
TEST(AgainstNaiveOnce, WhatTheComparisonSees)
{
    Picture picture = make_mixture(83, 57, 1);
    const Filtered found = filter_light(picture, {});
    const auto share_off = [&](const Picture& other, const Settings& settings) {
        const NaiveResult naive = naive_filter(other, other.diffuse, false, settings);
        int off = 0;
        for (std::size_t i = 0; i < naive.light[0].size(); ++i)
            off += std::fabs(static_cast<double>(found.diffuse.light[0][i]) - naive.light[0][i]) > 2e-5;
        return off / static_cast<double>(naive.light[0].size());
    };
    EXPECT_GT(share_off(picture, {0.2f, 2.0f}), 0.02);
    EXPECT_GT(share_off(picture, {1.0f, 0.8f}), 0.02);
    Picture flat = picture;
    std::fill(flat.guides.depth.begin(), flat.guides.depth.end(), 3.0f);
    EXPECT_GT(share_off(flat, {}), 0.02);
    Picture even = picture;
    std::fill(even.count.begin(), even.count.end(), 4.0f);
    EXPECT_GT(share_off(even, {}), 0.02);
}

} // namespace
} // namespace lambent::denoise::test
