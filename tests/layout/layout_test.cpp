// The folders under src/ and who may include whom: docs/ARCHITECTURE.md as a test.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace lambent {
namespace {

namespace fs = std::filesystem;

// What each folder may include besides itself. draw/cpu counts as draw.
const std::map<std::string, std::set<std::string>> allowed = {
    {"base", {}},
    {"equations", {}},
    {"wide", {"base", "equations"}},
    {"shading", {}},
    {"image", {"base"}},
    {"scene", {"base", "image", "equations"}},
    {"kitchen", {"base", "image", "equations", "scene"}},
    {"view", {"scene"}},
    {"trace", {"base", "scene", "wide"}},
    {"vulkan", {"base"}},
    {"environment", {"base", "image", "equations", "wide"}},
    {"gpu_layout", {}},
    {"draw",
     {"base", "image", "scene", "view", "trace", "environment", "equations", "shading", "wide", "vulkan",
      "gpu_layout"}},
    {"reference", {"base", "image", "scene", "view", "trace", "environment", "equations", "shading"}},
    {"display", {"image", "equations", "wide"}},
    {"compare", {"base", "image", "equations"}},
    {"api", {"base", "image", "environment", "lambent"}}, // lambent/bake.h
    {"apps",
     {"base", "equations", "wide", "image", "scene", "view", "trace", "environment", "draw", "reference",
      "display", "compare", "kitchen"}},
};

std::string folder_of(const fs::path& path)
{
    return path.begin()->string();
}

// Calls visit(file, what it includes) for every include in quotes.
template <class Visit>
void for_each_include(Visit&& visit)
{
    const fs::path root = LAMBENT_SOURCE_FOLDER;
    const std::regex include("^\\s*#\\s*include\\s*\"([^\"]*)\"");
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp" && extension != ".glsl" && extension != ".in")
            continue;
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string line; std::getline(file, line);)
            if (std::regex_search(line, match, include))
                visit(fs::relative(entry.path(), root), fs::path(match[1].str()));
    }
}

TEST(Layout, EveryFolderIncludesOnlyWhatTheDesignAllows)
{
    int includes = 0;
    for_each_include([&](const fs::path& file, const fs::path& path) {
        const std::string folder = folder_of(file), included = folder_of(path);
        ASSERT_TRUE(allowed.contains(folder)) << file << " is in a folder the design does not know";
        // Upwards a path could lead anywhere.
        EXPECT_EQ(std::count(path.begin(), path.end(), ".."), 0) << file << " includes " << path;
        if (!path.has_parent_path())
            return; // of its own folder
        ++includes;
        EXPECT_TRUE(included == folder || allowed.at(folder).contains(included))
            << file << " includes " << path;
    });
    EXPECT_GT(includes, 100);
}

// The reference is a second opinion only while it has none of the renderer's light.
TEST(Layout, TheReferenceTakesNothingFromTheBake)
{
    for_each_include([](const fs::path& file, const fs::path& path) {
        if (folder_of(file) == "reference" && folder_of(path) == "environment") {
            EXPECT_EQ(path, fs::path("environment/albedo_table.h")) << file;
        }
    });
}

// What is installed must not lead to what is not.
TEST(Layout, PublicHeadersIncludeOnlyTheStandardLibrary)
{
    int headers = 0;
    const std::regex include("^\\s*#\\s*include\\s*(.*)$"), standard("<[a-z_]+>");
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(LAMBENT_SOURCE_FOLDER) / "../include/lambent")) {
        ++headers;
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string line; std::getline(file, line);)
            if (std::regex_search(line, match, include)) {
                EXPECT_TRUE(std::regex_match(match[1].str(), standard)) << entry.path() << ": " << line;
            }
    }
    EXPECT_GT(headers, 0);
}

TEST(Layout, EveryFolderIsThere)
{
    for (const auto& [folder, others] : allowed)
        EXPECT_TRUE(fs::is_directory(fs::path(LAMBENT_SOURCE_FOLDER) / folder)) << folder;
}

} // namespace
} // namespace lambent
