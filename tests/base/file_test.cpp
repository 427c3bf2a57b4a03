// Whole files in and out, and what is refused.
#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>

#include <sys/stat.h>
#include <unistd.h>

namespace lambent {
namespace {

using testing::Folder;
using Bytes = std::vector<std::uint8_t>;

std::string contents(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Bytes bytes_of(const std::string& text)
{
    return {text.begin(), text.end()};
}

void expect_failure(Failure failure, const std::function<void()>& work)
{
    try {
        work();
        ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), failure) << error.what();
    }
}

TEST(Files, AreWrittenWholeAndLeaveNothingElse)
{
    const Folder folder;
    write_file(folder.path("a"), bytes_of("first, and long"));
    write_file(folder.path("a"), bytes_of("second"));
    EXPECT_EQ(contents(folder.path("a")), "second");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a"});
    EXPECT_EQ(read_file(folder.path("a")), bytes_of("second"));
    EXPECT_EQ(read_start(folder.path("a"), 3), bytes_of("sec"));
    EXPECT_EQ(read_start(folder.path("a"), 30), bytes_of("second"));
    EXPECT_EQ(file_size(folder.path("a")), 6u);
}

// A killed process may leave its temporary file, and a container's processes all have the same id.
TEST(Files, LeftoversOfOthersAreNeitherInTheWayNorRemoved)
{
    const Folder folder;
    std::vector<std::string> names = {"a"};
    for (int i = 0; i < 40; ++i) {
        names.push_back(text("a.", ::getpid(), ".", i, ".part"));
        std::ofstream(folder.path(names.back())) << "theirs";
    }
    write_file(folder.path("a"), bytes_of("ours"));
    EXPECT_EQ(contents(folder.path("a")), "ours");
    std::sort(names.begin(), names.end());
    EXPECT_EQ(folder.names(), names);
}

TEST(Files, WhatCannotBeReadIsBadInput)
{
    const Folder folder;
    write_file(folder.path("a"), bytes_of("12345"));
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    for (const std::string& path : {folder.path("none"), folder.path(""), folder.path("pipe")})
        expect_failure(Failure::bad_input, [&] { read_file(path); });
    expect_failure(Failure::bad_input, [&] { read_file(folder.path("a"), 4); });
}

TEST(Files, WhatCannotBeWrittenIsToldBeforeAndAfter)
{
    const Folder folder;
    write_file(folder.path("file"), {});
    for (const std::string& path : {folder.path("no/such"), folder.path(""), folder.path("file/x")}) {
        expect_failure(Failure::cannot_write, [&] { check_can_write(path); });
        expect_failure(Failure::cannot_write, [&] { write_file(path, bytes_of("x")); });
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"file"});
    EXPECT_NO_THROW(check_can_write(folder.path("new")));
}

} // namespace
} // namespace lambent
