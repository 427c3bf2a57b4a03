// The program under valgrind's memcheck: nothing that is not initialised decides anything. It knows no AVX-512, so that
// kernels and Embree run with AVX2. Nothing is suppressed.
#include "tests/processors/tools.h"
#include "tests/processors/works.h"

#include <gtest/gtest.h>

namespace lambent::processors {
namespace {

class Memcheck : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (const std::string why = missing("valgrind", "valgrind"); !why.empty())
            GTEST_SKIP() << why;
    }

    // Nothing but errors is written, and they give an exit code that the program has not.
    void expect_clean(const std::string& command, const std::string& output) const
    {
        const testing::Outcome outcome =
            run({"valgrind", "--quiet", "--error-exitcode=99"}, shop_.words(command, output));
        EXPECT_EQ(outcome.code, 0);
        EXPECT_EQ(outcome.error, "");
    }

    Workshop shop_;
};

TEST_F(Memcheck, APictureUsesNothingUninitialised)
{
    expect_clean("render", "picture.exr");
}

TEST_F(Memcheck, ShadowsUseNothingUninitialised)
{
    expect_clean("light", "light.exr");
}

TEST_F(Memcheck, ATraceUsesNothingUninitialised)
{
    expect_clean("reference", "trace.exr");
}

TEST_F(Memcheck, ABakeUsesNothingUninitialised)
{
    expect_clean("bake", "baked");
}

} // namespace
} // namespace lambent::processors
