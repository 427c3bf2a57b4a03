// The text as GLSL, on whatever Vulkan device there is, against the text in double.
#include "tests/equations/probes/parity.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace lambent::test {
namespace {

constexpr uint32_t probes_shader[] =
#include "probes/probes.comp.spv.inc"
    ;

// Results of all probes, one after another.
std::vector<float> probe_in_glsl(Compute& compute, const Arguments& arguments)
{
    const size_t probes = all_probes().size();
    std::array<std::vector<float>, 2> buffers = {
        arguments.numbers, std::vector<float>(probes * probe_outputs * arguments.points, NAN)};
    compute.run(probes_shader, buffers,
                {static_cast<uint32_t>(arguments.points / 64), static_cast<uint32_t>(probes), 1});
    return buffers[1];
}

TEST(ParityGlsl, AgreesWithDouble)
{
    const std::unique_ptr<Compute> compute = Compute::open();
    if (!compute) {
        ASSERT_FALSE(vulkan_required()) << "no Vulkan device";
        GTEST_SKIP() << "no Vulkan device";
    }
    const Arguments arguments = random_arguments();
    const std::vector<float> results = probe_in_glsl(*compute, arguments);
    const float* from = results.data();
    for (const Probe& probe : all_probes()) {
        const std::vector<double> wanted = probe_in_double(probe.number, arguments);
        const Worst worst = compare(probe, &Probe::glsl_bound, wanted, from, arguments.points);
        std::printf("%s %s\n", compute->device_name().c_str(), describe(probe, worst, arguments).c_str());
        EXPECT_LE(worst.ratio, 1.0) << probe.name;
        from += wanted.size();
    }
    EXPECT_EQ(compute->complaints(), std::vector<std::string>());
}

TEST(ParityGlsl, FiniteAtTheEndsOfItsDomain)
{
    const std::unique_ptr<Compute> compute = Compute::open();
    if (!compute) {
        ASSERT_FALSE(vulkan_required()) << "no Vulkan device";
        GTEST_SKIP() << "no Vulkan device";
    }
    const Arguments corners = corner_arguments();
    const std::vector<float> results = probe_in_glsl(*compute, corners);
    const size_t each = probe_outputs * corners.points;
    for (size_t i = 0; i < results.size(); i++)
        ASSERT_TRUE(std::isfinite(results[i]))
            << all_probes()[i / each].name << ": output " << i % each / corners.points << ", point "
            << i % corners.points;
}

} // namespace
} // namespace lambent::test
