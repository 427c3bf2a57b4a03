#include "base/text.h"

#include <gtest/gtest.h>

namespace lambent {
namespace {

TEST(Text, StreamsItsParts)
{
    EXPECT_EQ(text("size ", 3, "x", 4.5), "size 3x4.5");
}

TEST(Text, AMessageStaysOnItsLine)
{
    EXPECT_EQ(one_line("a\nb\tc\x1b[31m\x7f"), "a?b?c?[31m?");
    EXPECT_EQ(one_line("gr\xc3\xbc\xc3\x9f"), "gr\xc3\xbc\xc3\x9f");
}

} // namespace
} // namespace lambent
