#include "base/identity.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace lambent {
namespace {

TEST(Identity, IsOfOneThingAlone)
{
    Identity a, b;
    const Identity copy(a); // NOLINT(performance-unnecessary-copy-initialization)
    std::set<std::uint64_t> numbers = {a.number(), b.number(), copy.number()};
    EXPECT_EQ(numbers.size(), 3u);
    EXPECT_EQ(numbers.count(0), 0u);
    b = a; // other contents, so another thing
    EXPECT_TRUE(numbers.insert(b.number()).second);
}

// NOLINTBEGIN(bugprone-use-after-move,clang-analyzer-cplusplus.Move): what is left is looked at.
TEST(Identity, GoesWithTheContents)
{
    Identity a, b;
    const std::uint64_t first = a.number();
    Identity moved(std::move(a));
    EXPECT_EQ(moved.number(), first);
    EXPECT_NE(a.number(), first);
    b = std::move(moved);
    EXPECT_EQ(b.number(), first);
    EXPECT_NE(moved.number(), first);
}
// NOLINTEND(bugprone-use-after-move,clang-analyzer-cplusplus.Move)

} // namespace
} // namespace lambent
