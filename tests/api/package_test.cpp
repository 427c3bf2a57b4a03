// The project installed, and the example built against what was installed, as its reader would.
#include "tests/image/cube_reader.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;
using testing::run_program;

const std::string root = LAMBENT_ROOT;

void run_cmake(const std::vector<std::string>& words)
{
    const Outcome outcome = run_program(LAMBENT_CMAKE, words, 300.0);
    ASSERT_EQ(outcome.code, 0) << outcome.output << outcome.error;
}

TEST(Package, TheExampleBuildsAndBakesAgainstTheInstalledLibrary)
{
    const Folder folder;
    const std::string prefix = folder.path("prefix"), build = folder.path("build");
    ASSERT_NO_FATAL_FAILURE(run_cmake({"--install", LAMBENT_BUILD, "--prefix", prefix}));
    ASSERT_NO_FATAL_FAILURE(
        run_cmake({"-S", root + "/examples/bake", "-B", build, "-G", LAMBENT_GENERATOR,
                   "-DCMAKE_PREFIX_PATH=" + prefix, std::string("-DCMAKE_CXX_COMPILER=") + LAMBENT_COMPILER,
                   std::string("-DCMAKE_CXX_FLAGS=") + LAMBENT_FLAGS}));
    ASSERT_NO_FATAL_FAILURE(run_cmake({"--build", build}));

    const std::string output = folder.path("furnace.ktx2");
    const Outcome outcome = run_program(build + "/bake", {"furnace", output});
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    std::ifstream file(output, std::ios::binary);
    const test::CubeFile cube = test::read_ktx2({std::istreambuf_iterator<char>(file), {}});
    EXPECT_EQ(cube.size, 64u);
    ASSERT_EQ(cube.levels.size(), 7u);
    for (const auto& level : cube.levels)
        for (const test::Face& face : level)
            for (const test::Texel& texel : face)
                ASSERT_NEAR(texel[1], 1.0, 1e-2); // the error aimed at
    const std::regex line("roughness [01]\\.[0-9]{3}  error 0\\.[0-9]{4}\n");
    EXPECT_EQ(std::distance(std::sregex_iterator(outcome.output.begin(), outcome.output.end(), line), {}), 7)
        << outcome.output;

    const Outcome refused = run_program(build + "/bake", {"none.hdr", output});
    EXPECT_EQ(refused.code, 1);
    EXPECT_NE(refused.error.find("none.hdr"), std::string::npos) << refused.error;
}

TEST(Package, OnlyThePublicNamesAreVisible)
{
    const Outcome names = run_program(LAMBENT_NM, {"-D", "-C", "--defined-only", LAMBENT_LIBRARY});
    ASSERT_EQ(names.code, 0) << names.error;
    EXPECT_NE(names.output.find(" T lambent::bake_specular("), std::string::npos);
    const std::regex internal("lambent::(environment|image|in_double|Error)|lambent_|tbb::|Imf");
    std::istringstream lines(names.output);
    for (std::string line; std::getline(lines, line);)
        EXPECT_FALSE(std::regex_search(line, internal)) << line;
}

} // namespace
} // namespace lambent
