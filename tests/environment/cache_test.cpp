// The cache of environments: the same comes back, or nothing does.
#include "environment/cache/environment_cache.h"

#include "tests/environment/test_panoramas.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace lambent::environment {
namespace {

namespace fs = std::filesystem;

MadeEnvironment made_of(double light)
{
    MadeEnvironment made;
    made.environment =
        make_environment(testing::sunny_panorama(64, testing::normalized({1.0, 1.0, 0.3}), light));
    made.warnings = {"a line", "", "another line"};
    return made;
}

// Every texel and number, one by one.
void expect_same(const MadeEnvironment& a, const MadeEnvironment& b)
{
    EXPECT_EQ(a.warnings, b.warnings);
    const Environment &x = a.environment, &y = b.environment;
    EXPECT_EQ(x.panorama.width, y.panorama.width);
    EXPECT_EQ(x.panorama.scale, y.panorama.scale);
    EXPECT_EQ(x.panorama.texels, y.panorama.texels);
    ASSERT_EQ(x.lamps.lamps.size(), y.lamps.lamps.size());
    EXPECT_EQ(x.lamps.last_level, y.lamps.last_level);
    for (std::size_t i = 0; i < x.lamps.lamps.size(); ++i)
        EXPECT_EQ(x.lamps.lamps[i].light[1], y.lamps.lamps[i].light[1]);
    for (const auto& [p, q] : {std::pair(&x.chain, &y.chain), {&x.irradiance, &y.irradiance}}) {
        ASSERT_EQ(p->log2_size, q->log2_size);
        ASSERT_EQ(p->levels, q->levels);
        EXPECT_EQ(p->scale, q->scale);
        for (int level = 0; level < p->levels; ++level)
            for (std::size_t i = 3 * p->texel(level, 0, -1, -1);
                 i < 3 * p->texel(level, 5, p->face_size(level), p->face_size(level)) + 3; ++i)
                ASSERT_EQ(p->halfs()[i], q->halfs()[i]) << "level " << level;
    }
}

std::uint64_t bytes_in(const std::string& folder)
{
    std::uint64_t sum = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        sum += entry.file_size();
    return sum;
}

constexpr std::uint64_t plenty = std::uint64_t{1} << 30;

TEST(Cache, GivesBackWhatWasKept)
{
    const lambent::testing::Folder folder;
    const EnvironmentCache cache(folder.path("new/folder"), plenty);
    EXPECT_FALSE(cache.find("a"));
    const MadeEnvironment a = made_of(100.0), b = made_of(50000.0);
    cache.keep("a", a);
    cache.keep("b", b);
    ASSERT_TRUE(cache.find("a") && cache.find("b"));
    expect_same(*cache.find("a"), a);
    expect_same(*cache.find("b"), b);
    EXPECT_FALSE(cache.find("c"));
}

TEST(Cache, BrokenBytesAreNothing)
{
    const std::vector<std::uint8_t> bytes = to_bytes(made_of(100.0));
    ASSERT_TRUE(from_bytes(bytes));
    for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 97)
        EXPECT_FALSE(from_bytes(std::span(bytes).first(length))) << length;
    for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 97) {
        std::vector<std::uint8_t> wrong = bytes;
        wrong[at] ^= 0x10;
        EXPECT_FALSE(from_bytes(wrong)) << at;
    }
    std::vector<std::uint8_t> longer = bytes;
    longer.push_back(0);
    EXPECT_FALSE(from_bytes(longer));
}

TEST(Cache, BrokenFilesAreMadeAgain)
{
    const lambent::testing::Folder folder;
    const EnvironmentCache cache(folder.path(""), plenty);
    cache.keep("a", made_of(100.0));
    ASSERT_EQ(folder.names().size(), 1u);
    fs::resize_file(folder.path(folder.names()[0]), 1000);
    EXPECT_FALSE(cache.find("a"));
    cache.keep("a", made_of(100.0));
    EXPECT_TRUE(cache.find("a"));
}

TEST(Cache, StaysBelowItsLimitAndKeepsWhatIsUsed)
{
    const lambent::testing::Folder folder;
    const MadeEnvironment made = made_of(100.0);
    const std::uint64_t one = to_bytes(made).size(), limit = 3 * one + one / 2;
    const EnvironmentCache cache(folder.path(""), limit);
    const auto later = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
    for (const char* key : {"a", "b", "c"}) {
        cache.keep(key, made);
        later();
    }
    EXPECT_TRUE(cache.find("a")); // now "b" is the one not used for longest
    later();
    cache.keep("d", made);
    EXPECT_LE(bytes_in(folder.path("")), limit);
    EXPECT_TRUE(cache.find("a"));
    EXPECT_FALSE(cache.find("b"));
    EXPECT_TRUE(cache.find("c"));
    EXPECT_TRUE(cache.find("d"));
    EnvironmentCache(folder.path(""), one / 2).keep("e", made); // never more than all of it
    EXPECT_FALSE(cache.find("e"));
}

TEST(Cache, AFolderThatCannotBeIsNoCache)
{
    const lambent::testing::Folder folder;
    std::ofstream(folder.path("file")) << "x";
    const EnvironmentCache cache(folder.path("file/under"), plenty);
    cache.keep("a", made_of(100.0));
    EXPECT_FALSE(cache.find("a"));
}

// Processes that write and read the same key, some of them killed: whoever finds something finds all of it.
TEST(Cache, ManyProcessesAtOnce)
{
    const lambent::testing::Folder folder;
    const EnvironmentCache cache(folder.path(""), plenty);
    const MadeEnvironment made = made_of(100.0);
    std::vector<pid_t> children;
    for (int i = 0; i < 6; ++i)
        if (const pid_t child = ::fork(); child == 0) {
            for (int round = 0; round < 40; ++round) {
                cache.keep("a", made);
                // What is found passed its checksum; what is there but does not is a part.
                if (!cache.find("a"))
                    ::_exit(1);
            }
            ::_exit(0);
        } else {
            children.push_back(child);
        }
    ::usleep(20000);
    ::kill(children[0], SIGKILL);
    ::kill(children[1], SIGKILL);
    for (std::size_t i = 0; i < children.size(); ++i) {
        int status = 0;
        ::waitpid(children[i], &status, 0);
        if (i >= 2) {
            EXPECT_EQ(WEXITSTATUS(status), 0);
        }
    }
    ASSERT_TRUE(cache.find("a"));
    expect_same(*cache.find("a"), made);
}

TEST(Cache, ContentTellsFilesApart)
{
    const lambent::testing::Folder folder;
    std::ofstream(folder.path("a")) << std::string(3000000, 'a');
    std::ofstream(folder.path("b")) << std::string(3000000, 'a');
    std::ofstream(folder.path("c")) << std::string(2999999, 'a') << 'b';
    EXPECT_EQ(content_key(folder.path("a")), content_key(folder.path("b")));
    EXPECT_NE(content_key(folder.path("a")), content_key(folder.path("c")));
    EXPECT_THROW(content_key(folder.path("none")), Error);
}

} // namespace
} // namespace lambent::environment
