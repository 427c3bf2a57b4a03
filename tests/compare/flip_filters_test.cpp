// FLIP's filters: what they add up to, and their products against the papers' squares of weights.
#include "compare/flip_filters.h"
#include "tests/compare/naive_flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lambent::compare {
namespace {

constexpr double distances[] = {1.0, 5.0, 33.3, 67.0, 200.0};

double weight(const Filter& filter, int offset)
{
    const int i = offset + filter.radius;
    return i < 0 || i > 2 * filter.radius ? 0.0
                                          : static_cast<double>(filter.weights[static_cast<std::size_t>(i)]);
}

struct Sums {
    double negative = 0.0, positive = 0.0;
};

Sums sums(const Filter& filter)
{
    Sums sums;
    for (const float w : filter.weights)
        (w < 0.0f ? sums.negative : sums.positive) += static_cast<double>(w);
    return sums;
}

TEST(FlipFilters, ContrastFiltersKeepEvenColours)
{
    for (const double ppd : distances) {
        const FlipFilters f = make_flip_filters(ppd);
        for (const Filter* filter :
             {&f.achromatic, &f.red_green, &f.blue_yellow[0], &f.blue_yellow[1], &f.smooth}) {
            EXPECT_NEAR(sums(*filter).positive, 1.0, 1e-6) << ppd;
            EXPECT_EQ(sums(*filter).negative, 0.0);
            EXPECT_EQ(filter->weights.size(), static_cast<std::size_t>(2 * filter->radius + 1));
            EXPECT_LE(filter->radius, f.radius);
        }
        EXPECT_NEAR(f.blue_yellow_share[0] + f.blue_yellow_share[1], 1.0f, 1e-6f);
    }
}

TEST(FlipFilters, FeatureFiltersSeeNothingInEvenLightAndOneInAStep)
{
    for (const double ppd : distances) {
        const FlipFilters f = make_flip_filters(ppd);
        for (const Filter* filter : {&f.edge, &f.point}) {
            EXPECT_NEAR(sums(*filter).negative, -1.0, 1e-6) << ppd;
            EXPECT_NEAR(sums(*filter).positive, 1.0, 1e-6) << ppd;
        }
    }
}

TEST(FlipFilters, ContrastFiltersAreThePapersSquares)
{
    using test::Channel;
    for (const double ppd : distances) {
        const FlipFilters f = make_flip_filters(ppd);
        const test::Square a = test::naive_contrast_filter(Channel::achromatic, ppd);
        const test::Square rg = test::naive_contrast_filter(Channel::red_green, ppd);
        const test::Square by = test::naive_contrast_filter(Channel::blue_yellow, ppd);
        for (int y = -a.radius; y <= a.radius; ++y)
            for (int x = -a.radius; x <= a.radius; ++x) {
                EXPECT_NEAR(weight(f.achromatic, x) * weight(f.achromatic, y), a.at(x, y), 1e-7);
                EXPECT_NEAR(weight(f.red_green, x) * weight(f.red_green, y), rg.at(x, y), 1e-7);
                double sum = 0.0;
                for (int k = 0; k < 2; ++k)
                    sum += static_cast<double>(f.blue_yellow_share[k]) * weight(f.blue_yellow[k], x) *
                           weight(f.blue_yellow[k], y);
                EXPECT_NEAR(sum, by.at(x, y), 1e-7);
            }
    }
}

TEST(FlipFilters, FeatureFiltersAreThePapersSquares)
{
    for (const double ppd : distances) {
        const FlipFilters f = make_flip_filters(ppd);
        for (const bool point : {false, true}) {
            const test::Square square = test::naive_feature_filter(point, ppd);
            for (int y = -square.radius; y <= square.radius; ++y)
                for (int x = -square.radius; x <= square.radius; ++x)
                    EXPECT_NEAR(weight(point ? f.point : f.edge, x) * weight(f.smooth, y), square.at(x, y),
                                1e-7);
        }
    }
}

TEST(FlipFilters, WideAsThePaperSaysAtTheUsualDistance)
{
    // 3 sqrt(0.04 / (2 pi^2)) 67 = 9.05 and 3 * 0.041 * 67 = 8.24.
    const FlipFilters f = make_flip_filters(usual_pixels_per_degree);
    EXPECT_EQ(f.blue_yellow[0].radius, 10);
    EXPECT_EQ(f.edge.radius, 9);
    EXPECT_EQ(f.radius, 10);
}

TEST(FlipFilters, RefuseDistancesWithoutSense)
{
    for (const double ppd : {0.0, -67.0, 0.5, 1001.0, std::nan("")})
        EXPECT_THROW(make_flip_filters(ppd), std::invalid_argument) << ppd;
}

} // namespace
} // namespace lambent::compare
