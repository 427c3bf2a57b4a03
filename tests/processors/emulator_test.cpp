// The program on processors that this one is not: emulated by qemu, one that has SSE4.2 and not what our SSE4 target
// needs (Nehalem), one that has it all (Westmere) and one with AVX2 and without AVX-512 (Haswell).
#include "tests/processors/tools.h"
#include "tests/processors/works.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace lambent::processors {
namespace {

Runner emulated(const std::string& processor)
{
    return {"qemu-x86_64", "-cpu", processor};
}

// qemu 7.2 gets one instruction of AVX2 wrong, which the kernel of the background has or has not, as the compiler likes:
// seen as tiles of a wrong colour. There only exit codes count.
bool is_exact(const std::string& processor)
{
    return processor != "Haswell" ||
           testing::run_program("qemu-x86_64", {"-cpu", processor, LAMBENT_GATHER}).code == 0;
}

class Emulated : public ::testing::TestWithParam<std::string> {
protected:
    void SetUp() override
    {
        if (const std::string why = missing("qemu-x86_64", "qemu-user"); !why.empty())
            GTEST_SKIP() << why;
    }

    Workshop shop_;
};

TEST_P(Emulated, DrawsThePicture)
{
    const Values picture = shop_.picture(emulated(GetParam()));
    ASSERT_FALSE(picture.empty());
    const double far = distance(picture, shop_.picture({}));
    std::printf("picture: %.2e apart\n", far);
    if (is_exact(GetParam())) {
        EXPECT_LT(far, 1e-4); // as between instruction sets
    }
}

TEST_P(Emulated, DrawsShadows)
{
    const Values light = shop_.light(emulated(GetParam()));
    ASSERT_FALSE(light.empty());
    const double far = distance(light, shop_.light({}));
    std::printf("light: %.2e apart\n", far);
    if (is_exact(GetParam())) {
        EXPECT_LT(far, 0.01); // as between instruction sets
    }
}

TEST_P(Emulated, Traces)
{
    const Values trace = shop_.trace(emulated(GetParam()));
    ASSERT_FALSE(trace.empty());
    const double share = share_beyond(trace, shop_.trace({}), 1e-4);
    std::printf("trace: %.4f beyond\n", share);
    if (is_exact(GetParam())) {
        EXPECT_LT(share, 0.01);
    }
}

TEST_P(Emulated, Bakes)
{
    const Values bake = shop_.bake(emulated(GetParam()));
    ASSERT_FALSE(bake.empty());
    const double far = distance(bake, shop_.bake({}));
    std::printf("bake: %.2e apart\n", far);
    if (is_exact(GetParam())) {
        EXPECT_LT(far, 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Emulated, ::testing::Values("Nehalem", "Westmere", "Haswell"),
                         [](const auto& tested) { return tested.param; });

// What a processor lacks cannot be asked for.
TEST(EmulatedLimit, IsRefusedWhereTheProcessorLacksIt)
{
    if (const std::string why = missing("qemu-x86_64", "qemu-user"); !why.empty())
        GTEST_SKIP() << why;
    const testing::Outcome outcome =
        run({"qemu-x86_64", "-cpu", "Nehalem", "-E", "LAMBENT_ISA=avx2"}, {"--version"});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_NE(outcome.error.find("lambent: error: LAMBENT_ISA: this processor has no avx2\n"),
              std::string::npos)
        << outcome.error;
}

} // namespace
} // namespace lambent::processors
