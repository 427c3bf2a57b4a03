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

// What each folder under src/ may include besides itself and its rooms (its folders): the longest name that fits a file holds.
// A room of a folder that is not listed may include what the folder may.
const std::map<std::string, std::set<std::string>> allowed = {
    {"base", {}},
    {"albedo", {"equations"}},
    {"equations", {}},
    {"wide", {"base", "equations"}},
    {"shading", {}},
    {"image", {"base", "equations"}},
    {"scene", {"base", "image", "equations", "shading"}},
    {"view", {"scene"}},
    {"trace", {"base", "scene", "wide"}},
    {"vulkan", {"base"}},
    {"environment", {"base", "image", "equations", "wide"}},
    {"denoise", {"base", "image", "equations", "wide"}},
    {"gpu_layout", {"shading"}},
    {"draw",
     {"base", "image", "scene", "view", "trace", "environment", "denoise", "equations", "shading", "wide",
      "vulkan", "gpu_layout", "albedo"}},
    {"reference", {"base", "image", "scene", "view", "trace", "equations", "shading", "albedo"}},
    {"audit", {"base", "image", "scene", "view", "reference"}},
    {"display", {"image", "equations", "wide"}},
    {"compare", {"base", "image", "equations"}},
    {"api", {"base", "image", "environment", "lambent"}}, // lambent/bake.h
    // Each program is a room of its own.
    {"apps/options", {"base", "image", "scene", "environment", "draw", "display"}},
    {"apps/common",
     {"apps/options", "base", "wide", "image", "scene", "view", "environment", "denoise", "draw", "reference",
      "audit", "display", "compare"}},
    {"apps/viewer",
     {"apps/options", "apps/common", "base", "equations", "image", "scene", "environment", "draw",
      "reference", "audit", "compare"}},
    {"apps/view", {"apps/options", "apps/common", "apps/viewer", "base", "image", "scene", "environment"}},
    {"apps/serve", {"apps/options", "apps/common", "apps/viewer", "base", "image"}},
    {"apps/report", {"apps/options", "apps/common", "base", "image", "view", "draw", "reference", "compare"}},
    {"apps/cli",
     {"apps/options", "apps/common", "apps/report", "apps/serve", "base", "image", "scene", "environment",
      "compare", "audit"}},
};

// Files that a folder may hold before it should have rooms.
constexpr int most_files = 40;

std::string slashed(const fs::path& path)
{
    return path.generic_string();
}

bool is_in(const std::string& path, const std::string& folder)
{
    return path == folder || path.starts_with(folder + "/");
}

// The listed folder that a path is in; empty if there is none.
std::string listed_folder(const std::string& path)
{
    std::string found;
    for (const auto& [folder, others] : allowed)
        if (is_in(path, folder) && folder.size() > found.size())
            found = folder;
    return found;
}

bool may_include(const std::string& folder, const std::string& path)
{
    return is_in(path, folder) || std::ranges::any_of(allowed.at(folder), [&](const std::string& other) {
               return is_in(path, other);
           });
}

// Calls visit(file, what it includes) for every include in quotes.
template <class Visit>
void for_each_include(Visit&& visit)
{
    const fs::path root = LAMBENT_SOURCE_FOLDER;
    const std::regex include("^\\s*#\\s*include\\s*\"([^\"]*)\"");
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
        const std::string extension = entry.path().extension().string();
        static const std::set<std::string> texts = {".h", ".cpp", ".in", ".glsl", ".comp", ".vert", ".frag"};
        if (!texts.contains(extension))
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
    int includes = 0, shaders = 0;
    for_each_include([&](const fs::path& file, const fs::path& path) {
        const std::string folder = listed_folder(slashed(file.parent_path()));
        ASSERT_FALSE(folder.empty()) << file << " is in a folder the design does not know";
        // Upwards a path could lead anywhere.
        EXPECT_EQ(std::count(path.begin(), path.end(), ".."), 0) << file << " includes " << path;
        if (!path.has_parent_path() || path.extension() == ".inc")
            return; // of its own folder; what the build made of its shaders
        ++includes;
        shaders += file.extension() == ".comp" || file.extension() == ".frag";
        EXPECT_TRUE(may_include(folder, slashed(path))) << file << " includes " << path;
    });
    EXPECT_GT(includes, 100);
    EXPECT_GT(shaders, 10);
}

// Rooms that include each other are one room.
TEST(Layout, NoTwoRoomsIncludeEachOther)
{
    std::map<std::string, std::set<std::string>>
        below; // by folder, what its files include, and what these do
    for_each_include([&](const fs::path& file, const fs::path& path) {
        const std::string from = slashed(file.parent_path()), to = slashed(path.parent_path());
        if (!to.empty() && to != from)
            below[from].insert(to);
    });
    for (bool changed = true; changed;) {
        changed = false;
        for (auto& [folder, others] : below) {
            const std::set<std::string> before = others;
            for (const std::string& other : before)
                if (below.contains(other))
                    others.insert(below.at(other).begin(), below.at(other).end());
            changed = changed || others.size() != before.size();
        }
    }
    EXPECT_GT(below.size(), 20U);
    for (const auto& [folder, others] : below)
        EXPECT_FALSE(others.contains(folder)) << folder << " includes itself by way of others";
}

// A stranger finds the file.
TEST(Layout, NoFolderHoldsTooManyFiles)
{
    std::map<std::string, int> files;
    for (const char* top : {"", "../tools"})
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator(fs::path(LAMBENT_SOURCE_FOLDER) / top))
            if (entry.is_regular_file() && slashed(entry.path()).find("node_modules") == std::string::npos)
                ++files[slashed(entry.path().parent_path())];
    for (const auto& [folder, count] : files)
        EXPECT_LE(count, most_files) << folder;
}

// The reference is a second opinion only while it has none of the renderer's light: of environment/ nothing at all.
TEST(Layout, TheReferenceTakesNothingFromTheBake)
{
    EXPECT_FALSE(may_include("reference", "environment/bake/bake.h"));
    EXPECT_FALSE(may_include("reference", "draw/renderer.h"));
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
