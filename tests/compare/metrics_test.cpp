// Errors of pictures whose differences are known.
#include "compare/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lambent::compare {
namespace {

image::RadianceImage row(std::vector<float> values, int channels = 3)
{
    const int width = static_cast<int>(values.size()) / channels;
    return {width, 1, channels, std::move(values)};
}

TEST(Metrics, OfTwoPixels)
{
    const Metrics m = measure(row({1, 2, 3, 4, 5, 6}), row({1, 2, 3, 4, 5, 9}), 9.0);
    EXPECT_DOUBLE_EQ(m.rmse, std::sqrt(9.0 / 6.0));
    EXPECT_DOUBLE_EQ(m.relative_rmse, std::sqrt(9.0 / 6.0) / 4.0);
    EXPECT_DOUBLE_EQ(m.max, 3.0);
    EXPECT_NEAR(m.psnr, 20.0 * std::log10(9.0 / std::sqrt(1.5)), 1e-12);
}

TEST(Metrics, AlphaIsNotLookedAt)
{
    const Metrics m = measure(row({1, 1, 1, 0}, 4), row({1, 1, 1, 1}, 4), 1.0);
    EXPECT_EQ(m.rmse, 0.0);
    EXPECT_EQ(m.relative_rmse, 0.0);
    EXPECT_TRUE(std::isinf(m.psnr));
}

TEST(Metrics, AgainstBlackAnyLightIsInfinitelyMuch)
{
    EXPECT_TRUE(std::isinf(measure(row({1, 0, 0}), row({0, 0, 0}), 1.0).relative_rmse));
    EXPECT_EQ(measure(row({0, 0, 0}), row({0, 0, 0}), 1.0).relative_rmse, 0.0);
}

TEST(Metrics, ValuesAreCutAndMended)
{
    image::RadianceImage image = row({-1.0f, 0.5f, 7.0f});
    clamp_values(image, 1.0f);
    EXPECT_EQ(image.values, (std::vector<float>{0.0f, 0.5f, 1.0f}));
    const float infinity = std::numeric_limits<float>::infinity();
    image = row({infinity, std::nanf(""), 2.0f});
    EXPECT_EQ(mend_values(image), 2u);
    EXPECT_EQ(image.values, (std::vector<float>{0.0f, 0.0f, 2.0f}));
    EXPECT_EQ(largest_value(image), 2.0f);
}

} // namespace
} // namespace lambent::compare
