// Where samples go, by itself.
#include "draw/light/sample_plan.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw {
namespace {

constexpr int width = 320, height = 240, columns = width / SamplePlan::side;

// Squares whose pixels' samples deviate by `left` in the left half and by `right` in the right one, after the plan's passes.
std::vector<SamplePlan::Square> halves(const SamplePlan& plan, double left, double right)
{
    std::vector<SamplePlan::Square> squares(plan.size());
    for (std::size_t i = 0; i < squares.size(); ++i) {
        const int column = static_cast<int>(i) % columns;
        const double deviation = column < columns / 2 ? left : right;
        const auto taken = static_cast<double>(
            plan.taken(column * SamplePlan::side, static_cast<int>(i) / columns * SamplePlan::side));
        squares[i] = {64.0 * deviation * deviation / taken, 64.0};
    }
    return squares;
}

double mean_wanted(const SamplePlan& plan)
{
    double sum = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sum += plan.wanted(x, y);
    return sum / (width * height);
}

// Of the half of the picture that begins at x.
double mean_taken(const SamplePlan& plan, int x)
{
    double sum = 0.0;
    for (int y = 0; y < height; ++y)
        for (int i = 0; i < width / 2; ++i)
            sum += plan.taken(x + i, y);
    return sum / (width / 2 * height);
}

TEST(SamplePlan, TheFirstPassIsTheSameEverywhere)
{
    const SamplePlan plan(width, height);
    EXPECT_EQ(mean_wanted(plan), 2.0);
    EXPECT_EQ(plan.wanted(width - 1, height - 1), 2u);
    EXPECT_EQ(plan.taken(0, 0), 0u);
}

// After some passes the samples are in the ratio of the deviations, which makes the sum of the errors least.
TEST(SamplePlan, SamplesFollowTheDeviation)
{
    SamplePlan plan(width, height);
    for (int pass = 0; pass < 40; ++pass) {
        plan.end_pass();
        plan.plan(halves(plan, 3.0, 1.0));
        EXPECT_EQ(plan.wanted(10, 10) % 2, 0u);
        EXPECT_LE(plan.wanted(10, 10), SamplePlan::at_most);
    }
    EXPECT_NEAR(mean_taken(plan, 0) / mean_taken(plan, width / 2), 3.0, 0.2); // less at the border
}

TEST(SamplePlan, SpendsWhatAPassHas)
{
    SamplePlan plan(width, height);
    for (int pass = 1; pass < 60; ++pass) {
        plan.end_pass();
        plan.plan(halves(plan, 1.0 + 0.1 * pass, 2.0));
        EXPECT_LE(mean_wanted(plan), 1.4 + 1e-9);
    }
    EXPECT_NEAR(0.5 * (mean_taken(plan, 0) + mean_taken(plan, width / 2)), 2.0 + 1.4 * 58.0, 1.0);
}

// What the first samples have missed must come: a part without any error seen gets three tenths of the mean.
TEST(SamplePlan, NoPlaceIsForgotten)
{
    SamplePlan plan(width, height);
    for (int pass = 0; pass < 200; ++pass) {
        plan.end_pass();
        plan.plan(halves(plan, 1.0, 0.0));
    }
    // The mean deviation is about a half; three tenths of that.
    const double left = mean_taken(plan, 0), right = mean_taken(plan, width / 2);
    EXPECT_NEAR(right / left, 0.15, 0.03);
}

// A picture without noise, or without surfaces, is not a reason to stop or to divide by zero.
TEST(SamplePlan, WithoutErrorsAllPixelsGetAsMany)
{
    SamplePlan plan(width, height);
    plan.end_pass();
    plan.plan(halves(plan, 0.0, 0.0));
    EXPECT_EQ(mean_wanted(plan), 2.0);
    plan.plan(std::vector<SamplePlan::Square>(plan.size()));
    EXPECT_EQ(mean_wanted(plan), 2.0);
    SamplePlan empty(0, 0);
    empty.end_pass();
    empty.plan({});
    EXPECT_EQ(empty.size(), 0u);
}

// Squares that nothing covers cost nothing and take nothing.
TEST(SamplePlan, EmptySquaresDoNotCount)
{
    SamplePlan plan(width, height);
    plan.end_pass();
    std::vector<SamplePlan::Square> squares(plan.size());
    squares[plan.square_of(100, 100)] = {64.0, 64.0};
    plan.plan(squares);
    EXPECT_EQ(plan.wanted(0, 0), 0u);
    EXPECT_LE(plan.wanted(100, 100), 2u);
}

} // namespace
} // namespace lambent::draw
