// The documentation against the program: every command in it runs, its pictures are what their commands draw, every
// option is in it and every link leads somewhere.
#include "image/files/image_io.h"
#include "tests/scene/gltf_builder.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <iterator>
#include <set>
#include <sstream>

namespace lambent {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using testing::Outcome;

const fs::path root = LAMBENT_ROOT;

std::vector<fs::path> pages()
{
    std::vector<fs::path> pages = {root / "README.md", root / "CHANGELOG.md"};
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md")
            pages.push_back(entry.path());
    return pages;
}

std::string contents(const fs::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

using Command = std::vector<std::string>;

// Lines of code that are commands to type, without the program's name; forms with words to fill in are none.
std::vector<Command> commands(const fs::path& page)
{
    std::vector<Command> commands;
    std::istringstream lines(contents(page));
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("    lambent ", 0) != 0 || std::regex_search(line, std::regex(" \\[?[A-Z]{3,}")))
            continue;
        std::istringstream words(line.substr(12));
        commands.emplace_back(std::istream_iterator<std::string>(words),
                              std::istream_iterator<std::string>());
    }
    return commands;
}

// Files that commands read: two that are there, and what commands before them wrote.
const std::set<std::string> inputs = {"model.glb", "panorama.hdr", "picture.exr", "reference.exr"};

// A server at any free port, ended as soon as it says where it is.
Outcome run_server(const Folder& folder, const Command& command)
{
    std::string line =
        std::string(": >\"$0\"; '") + LAMBENT_PROGRAM + "'"; // looked into before it is written
    for (const std::string& word : command)
        line += " '" + word + "'";
    line += " --port 0 >\"$0\" & pid=$!; while kill -0 $pid && ! grep -q http \"$0\"; do sleep 0.05; done; "
            "kill -INT $pid; wait $pid";
    return testing::run_program("/bin/sh", {"-c", line, folder.path("address")});
}

// Everything but a window, which nobody would look at: without a display it says so when the scene is ready to be shown.
Outcome run_window(Command command)
{
    command.insert(command.begin(), {"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", LAMBENT_PROGRAM});
    Outcome outcome = testing::run_program("env", command);
    EXPECT_EQ(outcome.code, 4) << outcome.error;
    for (const char* expected : {"lambent: error: no window can be opened", "lambent: error: view: "})
        if (outcome.error.rfind(expected, 0) == 0) // the second: built without windows
            return {0, outcome.output, "", 0.0, 0.0};
    return outcome;
}

bool has_word(const Command& command, const char* word)
{
    return std::find(command.begin(), command.end(), word) != command.end();
}

Outcome run_command(const Folder& folder, Command command)
{
    if (command.at(0) == "view")
        return run_window(command);
    if (command.at(0) == "serve")
        return run_server(folder, command);
    // Where sanitizers make it slow, a page of smaller figures.
    if (command.at(0) == "report" && testing::patience > 1 && !has_word(command, "--size"))
        command.insert(command.end(), {"--size", "192x108"});
    if (!has_word(command, "vulkan"))
        return testing::run_program(LAMBENT_PROGRAM, command);
    // Drivers keep some memory to the end of the program, which is no leak of ours.
    command.insert(command.begin(), {"LSAN_OPTIONS=detect_leaks=0", LAMBENT_PROGRAM});
    return testing::run_program("env", command);
}

// Runs a command with the files it names in the folder; the last word of those after -o is returned.
fs::path run_in(const Folder& folder, Command command)
{
    fs::path output;
    for (std::size_t i = 0; i < command.size(); ++i) {
        std::string& word = command[i];
        if (i > 0 && command[i - 1] == "-o")
            word = output = folder.path(fs::path(word).filename().string());
        else if (inputs.contains(word))
            word = folder.path(word);
    }
    const Outcome outcome = run_command(folder, command);
    if (outcome.code == 4 && !std::getenv("LAMBENT_REQUIRE_VULKAN") && has_word(command, "vulkan")) {
        std::printf("skipped: %s", outcome.error.c_str());
        return {};
    }
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    if (!output.empty()) {
        EXPECT_TRUE(fs::exists(output)) << output;
    }
    return output;
}

void write_example_files(const Folder& folder)
{
    const auto model = scene::test::triangle().glb();
    std::ofstream(folder.path("model.glb"), std::ios::binary)
        .write(reinterpret_cast<const char*>(model.data()), static_cast<std::streamsize>(model.size()));
    run_in(folder, {"env", "sky", "--size", "128x64", "-o", "panorama.hdr"});
}

// Code values by which two pictures differ: the mean, and the share of bytes that do by more than 6.
struct Difference {
    double mean, far;
};

Difference difference(const image::CodeImage& a, const image::CodeImage& b)
{
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.bytes.size(), b.bytes.size());
    const double share = 1.0 / static_cast<double>(a.bytes.size());
    Difference sum{};
    for (std::size_t i = 0; i < std::min(a.bytes.size(), b.bytes.size()); ++i) {
        const int apart = std::abs(a.bytes[i] - b.bytes[i]);
        sum.mean += share * apart;
        sum.far += apart > 6 ? share : 0.0;
    }
    return sum;
}

TEST(Docs, EveryCommandRunsAndDrawsTheCommittedPicture)
{
    const Folder folder;
    write_example_files(folder);
    int run = 0;
    std::set<fs::path> drawn;
    for (const fs::path& page : pages())
        for (const Command& command : commands(page)) {
            ++run;
            const fs::path output = run_in(folder, command);
            const fs::path committed = root / "docs/pictures" / output.filename();
            if (std::find(command.begin(), command.end(), "docs/pictures/" + output.filename().string()) ==
                command.end())
                continue;
            drawn.insert(committed);
            // A code value or two where instructions round otherwise; another picture is off by many.
            const Difference apart = difference(image::read_codes(output), image::read_codes(committed));
            EXPECT_LT(apart.mean, 0.5) << committed;
            EXPECT_LE(apart.far, 0.005) << committed;
        }
    EXPECT_GT(run, 8);
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "docs/pictures"))
        EXPECT_TRUE(drawn.contains(entry.path())) << entry.path() << " has no command";
}

TEST(Docs, EveryPictureIsOneOfTheReports)
{
    if (testing::patience > 1)
        GTEST_SKIP() << "the page at full size takes more than ten minutes with sanitizers";
    const Folder folder;
    const fs::path output = run_in(folder, {"report", "--quick", "-o", "report"});
    int pictures = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "docs/pictures")) {
        const fs::path drawn = output / entry.path().filename();
        ASSERT_TRUE(fs::exists(drawn)) << drawn;
        const Difference apart = difference(image::read_codes(drawn), image::read_codes(entry.path()));
        EXPECT_LT(apart.mean, 0.5) << drawn;
        EXPECT_LE(apart.far, 0.005) << drawn;
        ++pictures;
    }
    EXPECT_GT(pictures, 5);
}

TEST(Docs, EveryLinkLeadsSomewhere)
{
    const std::regex link("\\]\\(([^):#]+)\\)");
    int links = 0;
    for (const fs::path& page : pages()) {
        const std::string text = contents(page);
        for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i) {
            ++links;
            EXPECT_TRUE(fs::exists(page.parent_path() / (*i)[1].str())) << page << ": " << (*i)[1];
        }
    }
    EXPECT_GT(links, 10);
}

// Indented as code, line by line.
TEST(Docs, TheLibraryPageShowsTheExample)
{
    std::istringstream lines(contents(root / "examples/bake/main.cpp"));
    std::string shown;
    for (std::string line; std::getline(lines, line);)
        shown += line.empty() ? "\n" : "    " + line + "\n";
    EXPECT_GT(shown.size(), 500u);
    EXPECT_NE(contents(root / "docs/LIBRARY.md").find(shown), std::string::npos);
}

std::set<std::string> options_in(const std::string& text)
{
    std::set<std::string> options;
    const std::regex option("(?:^|[\\s,`|])(--[a-z][a-z-]+)");
    for (std::sregex_iterator i(text.begin(), text.end(), option), end; i != end; ++i)
        options.insert((*i)[1]);
    return options;
}

TEST(Docs, CliListsEveryOptionAndNoOther)
{
    std::set<std::string> real;
    for (const Command& command : {Command{"--help"},
                                   {"render", "--help"},
                                   {"bake", "--help"},
                                   {"reference", "--help"},
                                   {"compare", "--help"},
                                   {"report", "--help"},
                                   {"view", "--help"},
                                   {"serve", "--help"},
                                   {"env", "--help"},
                                   {"info", "--help"}})
        real.merge(options_in(testing::run_program(LAMBENT_PROGRAM, command).output));
    EXPECT_EQ(options_in(contents(root / "docs/CLI.md")), real);
}

} // namespace
} // namespace lambent
