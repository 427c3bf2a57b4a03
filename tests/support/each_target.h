// The same test for every Highway target that this processor has.
#pragma once

#include <gtest/gtest.h>
#include <hwy/highway.h>

namespace lambent::test {

/// A fixture whose parameter is the target; derive, TEST_P and LAMBENT_EACH_TARGET.
class EachTarget : public testing::TestWithParam<int64_t> {
protected:
    void SetUp() override { use(GetParam()); }
    void TearDown() override { use(0); }

private:
    // 0: the best.
    static void use(int64_t target)
    {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().DeInit();
    }
};

} // namespace lambent::test
