// The same test with every instruction set: kernels and Embree alike. See wide/instruction_sets.h.
#pragma once

#include "wide/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace lambent::test {

inline bool is_available(const std::string& instruction_set)
{
    const std::vector<std::string> all = wide::available_instruction_sets();
    return std::find(all.begin(), all.end(), instruction_set) != all.end();
}

/// A fixture whose parameter is the instruction set; derive, TEST_P and LAMBENT_EACH_INSTRUCTION_SET.
class EachInstructionSet : public ::testing::TestWithParam<std::string> {
protected:
    void SetUp() override
    {
        if (!is_available(GetParam()))
            GTEST_SKIP() << "this processor has no " << GetParam();
        before_ = wide::instruction_limit();
        wide::limit_instructions(GetParam());
    }
    void TearDown() override { wide::limit_instructions(before_); }

private:
    std::string before_;
};

inline std::string name_of(const ::testing::TestParamInfo<std::string>& tested)
{
    std::string name = tested.param;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

} // namespace lambent::test

#define LAMBENT_EACH_INSTRUCTION_SET(fixture)                                                                \
    INSTANTIATE_TEST_SUITE_P(All, fixture, ::testing::ValuesIn(lambent::wide::instruction_sets()),           \
                             lambent::test::name_of)
