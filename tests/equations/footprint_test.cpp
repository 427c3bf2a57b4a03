#include "equations/in_double.h"
#include "tests/equations/quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lambent::test {
namespace {

using in_double::level_of_variance;
using in_double::variance_of_spread;

// Variance of level l over that of level 1: what the chain is made of.
double variance_of_level(int level)
{
    return level == 0 ? 1.0 / 16.0 : std::pow(4.0, level - 1);
}

// Trilinear filtering blends two neighbouring levels; the variances of a mixture of two Gaussians about one
// point add in proportion.
double variance_of_blend(double level)
{
    const int below = static_cast<int>(std::floor(level));
    const double share = level - below;
    return (1.0 - share) * variance_of_level(below) + share * variance_of_level(below + 1);
}

TEST(Footprint, BlendHasTheWantedVarianceOverFourDecades)
{
    for (int i = 0; i <= 4000; i++) {
        const double variance = std::pow(10.0, -1.0 + i / 1000.0);
        EXPECT_NEAR(variance_of_blend(level_of_variance(variance)) / variance, 1.0, 1e-12) << variance;
    }
}

TEST(Footprint, PartsOfAChain)
{
    EXPECT_EQ(in_double::part_of_levels(0.0, 7.0), 0.0);
    EXPECT_EQ(in_double::part_of_levels(3.5, 7.0), 0.5);
    EXPECT_EQ(in_double::part_of_levels(7.0, 7.0), 1.0);
    EXPECT_EQ(in_double::part_of_levels(12.0, 7.0), 1.0);
    EXPECT_EQ(in_double::part_of_levels(0.0, 0.0), 0.0) << "one level";
}

TEST(Footprint, LevelsThemselves)
{
    for (int level = 0; level <= 12; level++)
        EXPECT_NEAR(level_of_variance(variance_of_level(level)), level, 1e-12);
}

TEST(Footprint, NothingIsSharperThanThePicture)
{
    EXPECT_EQ(level_of_variance(0.0), 0.0);
    EXPECT_EQ(level_of_variance(0.0624), 0.0);
}

TEST(Footprint, LevelNeverFalls)
{
    double last = 0.0;
    for (int i = 0; i <= 100000; i++) {
        const double level = level_of_variance(std::pow(10.0, -3.0 + i / 12500.0));
        EXPECT_GE(level, last);
        last = level;
    }
}

TEST(Footprint, DeviationIsHalfOfTheSpread)
{
    for (double spread : {1e-8, 0.04, 1.0, 6.0})
        EXPECT_NEAR(std::sqrt(variance_of_spread(spread)), std::sqrt(0.3) * std::sqrt(spread), 1e-14);
}

// What a lamp, a Gaussian of its own variance, shows of a lobe: samples in a sunflower spiral, drawn from a Gaussian lobe of
// deviation 1 on the plane, each the Gaussian that stands for its share.
class LampThroughALobe {
public:
    LampThroughALobe(int samples, double lamp)
    {
        for (int i = 0; i < samples; i++) {
            const double left = 1.0 - (i + 0.5) / samples; // of the lobe outside this sample
            const double radius = std::sqrt(-2.0 * std::log(left)), phi = 2.399963229728653 * i;
            const double density = left / (2.0 * std::numbers::pi);
            samples_.push_back({radius * std::cos(phi), radius * std::sin(phi),
                                lamp + variance_of_spread(1.0 / (samples * density))});
        }
    }

    // Over what the lobe itself has in its middle.
    double at(double x, double y) const
    {
        double sum = 0.0;
        for (const Sample& s : samples_) {
            const double dx = x - s.x, dy = y - s.y;
            sum += std::exp(-0.5 * (dx * dx + dy * dy) / s.variance) / s.variance;
        }
        return sum / static_cast<double>(samples_.size());
    }

    // By how much it rises again, having fallen from its maximum, along a line through the middle.
    double rise_along(double angle) const
    {
        std::vector<double> line;
        for (int i = -300; i <= 300; i++)
            line.push_back(at(0.01 * i * std::cos(angle), 0.01 * i * std::sin(angle)));
        const auto peak = std::max_element(line.begin(), line.end());
        double rise = 0.0, lowest = *peak;
        for (auto i = peak; i != line.end(); ++i) {
            lowest = std::min(lowest, *i);
            rise = std::max(rise, *i - lowest);
        }
        lowest = *peak;
        for (auto i = peak; i != line.begin(); --i) {
            lowest = std::min(lowest, *i);
            rise = std::max(rise, *i - lowest);
        }
        return rise;
    }

private:
    struct Sample {
        double x, y, variance;
    };
    std::vector<Sample> samples_;
};

double worst_rise(int samples, double lamp)
{
    const LampThroughALobe seen(samples, lamp);
    double worst = 0.0;
    for (int i = 0; i < 24; i++)
        worst = std::max(worst, seen.rise_along(i * std::numbers::pi / 24.0));
    return worst;
}

// At the usual 40 samples one maximum and no dots around it, and of a lamp a fifth as wide as the lobe a ripple too faint to
// see; smaller ones are not left to the blurs.
TEST(Footprint, ALampShowsNoSamples)
{
    EXPECT_LT(worst_rise(40, 0.04), 1e-2);
    EXPECT_LT(worst_rise(200, 0.04), 0.03);
}

// Nor is the highlight washed out: as bright in its middle and at one deviation as the lobe, within a twentieth.
TEST(Footprint, ALampKeepsTheLobesShape)
{
    const LampThroughALobe sun(40, 0.0);
    EXPECT_NEAR(sun.at(0.0, 0.0), 1.0, 0.05);
    double mean = 0.0;
    for (int i = 0; i < 24; i++)
        mean += sun.at(std::cos(i * std::numbers::pi / 12.0), std::sin(i * std::numbers::pi / 12.0)) / 24.0;
    EXPECT_NEAR(mean, std::exp(-0.5), 0.05 * std::exp(-0.5));
}

// A blend of two levels has the variance asked for.
TEST(Footprint, ShareOfTheCoarserLevel)
{
    const in_double::vec2 levels(0.02, 0.08);
    for (double variance : {0.02, 0.03, 0.05, 0.08}) {
        const double share = in_double::share_of_coarser(variance, levels);
        EXPECT_NEAR((1.0 - share) * levels.x + share * levels.y, variance, 1e-15);
    }
    EXPECT_EQ(in_double::share_of_coarser(0.001, levels), 0.0);
    EXPECT_EQ(in_double::share_of_coarser(1.0, levels), 1.0);
}

// Its light, and its mean square angle: two variances while it is narrow.
TEST(Footprint, GaussianOnTheSphereIsADensity)
{
    for (double variance : {1e-4, 1e-2, 0.1, 0.5}) {
        const auto ring = [&](double angle) {
            const double chord = 2.0 * std::sin(0.5 * angle);
            return 2.0 * pi * std::sin(angle) * in_double::gaussian_on_sphere(chord * chord, variance);
        };
        const double end = std::min(pi, 12.0 * std::sqrt(variance));
        EXPECT_NEAR(integrate(ring, 0.0, end, 1e-12, 16), 1.0, 1e-9) << variance;
        const auto square = [&](double angle) { return angle * angle * ring(angle); };
        EXPECT_NEAR(integrate(square, 0.0, end, 1e-12, 16) / (2.0 * variance), 1.0, variance) << variance;
    }
}

// Two normals at the least cosine mirror one view to directions that differ by alpha; in the bounds of mirrors and of
// rough surfaces by a hundredth, and by twice the angle that is given.
TEST(Footprint, SharedNormalsMirrorToWithinALobe)
{
    for (const auto& [alpha, between] :
         {std::pair(0.0, 0.01), {0.004, 0.01}, {0.03, 0.03}, {0.2, 0.2}, {0.9, 2.0 * std::acos(0.966)}}) {
        const double angle = std::acos(in_double::shared_cosine(alpha, 0.966));
        const in_double::vec3 view(0.6, 0.0, 0.8), tilted(std::sin(angle), 0.0, std::cos(angle));
        const in_double::vec3 a = in_double::mirrored(in_double::vec3(0.0, 0.0, 1.0), view),
                              b = in_double::mirrored(tilted, view);
        EXPECT_NEAR(std::atan2(a.x * b.z - a.z * b.x, a.x * b.x + a.z * b.z), -between, 1e-9) << alpha;
    }
    EXPECT_EQ(in_double::shared_cosine(0.5, 2.0), 2.0); // no two samples are shaded as one
}

} // namespace
} // namespace lambent::test
