// Entries drawn by their weights.
#include "reference/discrete_distribution.h"

#include "tests/equations/uniform.h"
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <limits>

namespace lambent::reference {
namespace {

template <class Number>
class DiscreteDistributionOf : public ::testing::Test {
};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(DiscreteDistributionOf, Numbers);

// More than a block of entries, some of weight 0: at both ends, alone, and a whole block of them.
std::vector<double> uneven_weights()
{
    std::vector<double> weights(200);
    for (std::size_t i = 0; i < weights.size(); ++i)
        weights[i] = i < 3 || i == 20 || (i >= 64 && i < 96) || i > 190
                         ? 0.0
                         : 1.0 + std::sin(0.7 * static_cast<double>(i));
    return weights;
}

double sum_of(const std::vector<double>& weights)
{
    double sum = 0.0;
    for (const double weight : weights)
        sum += weight;
    return sum;
}

TYPED_TEST(DiscreteDistributionOf, DrawsByWeight)
{
    for (const std::vector<double>& weights : {uneven_weights(), std::vector<double>{1e-3, 5.0, 1.0},
                                               std::vector<double>(32, 1.0), std::vector<double>(33, 1.0)}) {
        const DiscreteDistribution<TypeParam> distribution(weights);
        std::vector<double> probabilities;
        for (const double weight : weights)
            probabilities.push_back(weight / sum_of(weights));
        test::Uniform uniform(3);
        const auto draw = [&] { return distribution.draw(uniform()).index; };
        EXPECT_TRUE(test::follows(test::count(100000, weights.size(), draw), probabilities));
    }
}

// What is left of the random number is uniform again, whatever was drawn.
TYPED_TEST(DiscreteDistributionOf, PlacesAreUniform)
{
    const DiscreteDistribution<TypeParam> distribution(uneven_weights());
    test::Uniform uniform(4);
    const auto draw = [&] {
        const double place = distribution.draw(uniform()).place;
        EXPECT_TRUE(place >= 0.0 && place <= 1.0);
        return test::part_of(place, 50);
    };
    EXPECT_TRUE(test::follows_evenly(test::count(100000, 50, draw)));
}

TYPED_TEST(DiscreteDistributionOf, ProbabilitiesAreSharesOfTheSum)
{
    const std::vector<double> weights = uneven_weights();
    const DiscreteDistribution<TypeParam> distribution(weights);
    EXPECT_DOUBLE_EQ(distribution.sum(), sum_of(weights));
    double total = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        total += distribution.probability(i);
        EXPECT_NEAR(distribution.probability(i), weights[i] / sum_of(weights),
                    std::numeric_limits<TypeParam>::epsilon());
    }
    EXPECT_NEAR(total, 1.0, 1e-12);
}

TYPED_TEST(DiscreteDistributionOf, EntriesOfNoWeightAreNeverDrawn)
{
    const std::vector<double> weights = uneven_weights();
    const DiscreteDistribution<TypeParam> distribution(weights);
    const double most = 1.0 - 0x1p-53;
    double just_before = 0.0; // of each entry's end, and at it
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double end = just_before + distribution.probability(i);
        for (const double u : {just_before, std::nextafter(end, 0.0), end})
            if (u >= 0.0 && u <= most) {
                EXPECT_GT(weights[distribution.draw(u).index], 0.0) << u;
            }
        just_before = end;
    }
    EXPECT_GT(weights[distribution.draw(0.0).index], 0.0);
    EXPECT_GT(weights[distribution.draw(most).index], 0.0);
}

TYPED_TEST(DiscreteDistributionOf, OneEntryIsAlwaysDrawn)
{
    for (const double weight : {1e-300, 1.0, 1e300}) {
        const DiscreteDistribution<TypeParam> distribution(std::vector<double>{weight});
        EXPECT_EQ(distribution.probability(0), 1.0);
        for (const double u : {0.0, 0.25, 1.0 - 0x1p-53}) {
            EXPECT_EQ(distribution.draw(u).index, 0U);
            EXPECT_DOUBLE_EQ(distribution.draw(u).place, u);
        }
    }
}

TYPED_TEST(DiscreteDistributionOf, NothingToDrawIsASumOfZero)
{
    EXPECT_EQ(DiscreteDistribution<TypeParam>().sum(), 0.0);
    EXPECT_EQ(DiscreteDistribution<TypeParam>(std::vector<double>{}).sum(), 0.0);
    EXPECT_EQ(DiscreteDistribution<TypeParam>(std::vector<double>(5, 0.0)).sum(), 0.0);
}

TYPED_TEST(DiscreteDistributionOf, WeightsWithoutAMeaningAreRefused)
{
    constexpr double infinity = std::numeric_limits<double>::infinity(),
                     nan = std::numeric_limits<double>::quiet_NaN();
    for (const std::vector<double>& weights :
         {std::vector<double>{1.0, nan}, {infinity}, {1.0, -1e-9, 1.0}, {-infinity, 2.0}, {1.7e308, 1.7e308}})
        EXPECT_THROW(DiscreteDistribution<TypeParam>{weights}, std::invalid_argument);
}

} // namespace
} // namespace lambent::reference
