// Pictures, traces and bakes with every instruction set that this processor has: the same but for rounding.
#include "tests/processors/works.h"
#include "tests/support/each_instruction_set.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace lambent::processors {
namespace {

// Kernels round to about 1e-6. The blurs of the environment and what is baked are halfs, in steps of 2^-10: of two values of a texel so near
// each other, one in a thousand pairs lies on both sides of a rounding, and then a step apart. Root mean square 3e-5.
constexpr double rounding = 1e-4;

class InstructionSets : public ::testing::TestWithParam<std::string> {
protected:
    void SetUp() override
    {
        if (!test::is_available(GetParam()))
            GTEST_SKIP() << "this processor has no " << GetParam();
    }

    // With the oldest one.
    static const Works& first()
    {
        static const Works works = Workshop().all(limited_to(wide::instruction_sets().front()));
        return works;
    }
};

TEST_P(InstructionSets, DrawWhatTheOldestDraws)
{
    const Values picture = Workshop().picture(limited_to(GetParam()));
    const double far = distance(picture, first().picture);
    std::printf("picture: %.2e apart, %.4f beyond\n", far, share_beyond(picture, first().picture, 1e-5));
    EXPECT_LT(far, rounding);
}

// Rounding decides here and there which lamp a ray goes to, and which blur the filter takes.
TEST_P(InstructionSets, ShadeWhatTheOldestShades)
{
    const Values light = Workshop().light(limited_to(GetParam()));
    const double far = distance(light, first().light);
    std::printf("light: %.2e apart, %.4f beyond\n", far, share_beyond(light, first().light, 1e-3));
    EXPECT_LT(far, 0.01);
    EXPECT_LT(share_beyond(light, first().light, 1e-3), 0.1);
}

// Traced in double but for the hits, which Embree rounds: values move by 1e-6, and only where a ray passes an edge so near
// does a path go another way.
TEST_P(InstructionSets, TraceWhatTheOldestTraces)
{
    const Values trace = Workshop().trace(limited_to(GetParam()));
    const double share = share_beyond(trace, first().trace, 1e-4);
    std::printf("trace: %.2e apart, %.4f beyond\n", distance(trace, first().trace), share);
    EXPECT_LT(share, 0.01);
}

TEST_P(InstructionSets, BakeWhatTheOldestBakes)
{
    const Values bake = Workshop().bake(limited_to(GetParam()));
    const double far = distance(bake, first().bake);
    std::printf("bake: %.2e apart, %.4f beyond\n", far, share_beyond(bake, first().bake, 1e-5));
    EXPECT_LT(far, rounding);
}

LAMBENT_EACH_INSTRUCTION_SET(InstructionSets);

// What the program says of its device is what its kernels run on.
TEST(InstructionLimit, ReachesTheKernels)
{
#ifdef LAMBENT_SANITIZED // there are kernels for two targets alone
    const std::pair<const char*, const char*> targets[] = {
        {"sse2", "SCALAR"}, {"sse4.2", "SCALAR"}, {"avx", "SCALAR"}, {"avx2", "AVX2"}, {"avx512", "AVX2"}};
#else
    const std::pair<const char*, const char*> targets[] = {
        {"sse2", "SCALAR"}, {"sse4.2", "SSE4"}, {"avx", "SSE4"}, {"avx2", "AVX2"}, {"avx512", "AVX3"}};
#endif
    const Workshop shop;
    int seen = 0;
    for (const auto& [set, target] : targets) {
        if (!test::is_available(set))
            continue;
        std::vector<std::string> words = shop.words("render", "picture.exr");
        words.insert(words.end(), {"--stats", "json"});
        const testing::Outcome outcome = run(limited_to(set), words);
        EXPECT_NE(outcome.output.find(std::string("\"device\":\"") + target), std::string::npos)
            << set << ": " << outcome.output << outcome.error;
        ++seen;
    }
    EXPECT_GT(seen, 0);
}

TEST(InstructionLimit, IsRefusedWhereItIsUnknown)
{
    const testing::Outcome outcome = run(limited_to("avx3"), {"--version"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.error,
              "lambent: error: LAMBENT_ISA: unknown instruction set 'avx3' (sse2, sse4.2, avx, avx2, "
              "avx512)\n");
    EXPECT_EQ(outcome.output, "");
}

} // namespace
} // namespace lambent::processors
