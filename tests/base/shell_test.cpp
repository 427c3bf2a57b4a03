#include "base/shell.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

namespace lambent {
namespace {

TEST(Shell, WordsAreQuotedWhereTheyMust)
{
    EXPECT_EQ(shell_quoted("a-b_c/d.e,f:1"), "a-b_c/d.e,f:1");
    EXPECT_EQ(shell_quoted(""), "''");
    EXPECT_EQ(shell_quoted("a b"), "'a b'");
    EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
    for (const std::string word :
         {"$(reboot)", "`x`", "a;b", "a\nb", "~", "*", "\\", "\"'\"", "#a", "!x", "\xc3\xa4"}) {
        // The shell itself is the judge.
        const testing::Outcome outcome =
            testing::run_program("/bin/sh", {"-c", "printf %s " + shell_quoted(word)});
        EXPECT_EQ(outcome.output, word);
    }
}

} // namespace
} // namespace lambent
