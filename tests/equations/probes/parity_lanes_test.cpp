// The text over the lanes of every Highway target of this processor against the text in double.
#include "tests/equations/probes/parity.h"
#include "tests/support/each_target.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lambent::test {
namespace {

class Parity : public EachTarget {};

TEST_P(Parity, LanesAgreeWithDouble)
{
    const Arguments arguments = random_arguments();
    for (const Probe& probe : all_probes()) {
        const std::vector<double> wanted = probe_in_double(probe.number, arguments);
        const std::vector<float> results = probe_over_lanes(probe.number, arguments);
        const Worst worst = compare(probe, &Probe::lanes_bound, wanted, results.data(), arguments.points);
        std::printf("%s %s\n", hwy::TargetName(GetParam()), describe(probe, worst, arguments).c_str());
        EXPECT_LE(worst.ratio, 1.0) << probe.name;
    }
}

TEST_P(Parity, LanesAreFiniteAtTheEndsOfTheirDomain)
{
    const Arguments corners = corner_arguments();
    for (const Probe& probe : all_probes()) {
        const std::vector<float> results = probe_over_lanes(probe.number, corners);
        const auto bad =
            std::find_if(results.begin(), results.end(), [](float r) { return !std::isfinite(r); });
        const size_t at = static_cast<size_t>(bad - results.begin());
        EXPECT_EQ(bad, results.end())
            << probe.name << ": output " << at / corners.points << ", point " << at % corners.points;
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, Parity, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& info) { return std::string(hwy::TargetName(info.param)); });

TEST(Probes, AreNumberedInOrder)
{
    for (size_t i = 0; i < all_probes().size(); i++)
        EXPECT_EQ(all_probes()[i].number, static_cast<int>(i));
}

TEST(Probes, DoubleIsFiniteAtTheEndsOfItsDomain)
{
    const Arguments corners = corner_arguments();
    for (const Probe& probe : all_probes())
        for (double result : probe_in_double(probe.number, corners))
            ASSERT_TRUE(std::isfinite(result)) << probe.name;
}

} // namespace
} // namespace lambent::test
