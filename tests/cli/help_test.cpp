// Help, and what is said of mistyped words.
#include "tests/cli/lambent.h"

#include <gtest/gtest.h>

#include <sstream>

namespace lambent {
namespace {

using testing::Outcome;

const std::vector<std::string> commands = {"render", "bake",  "reference", "compare", "report",
                                           "view",   "serve", "env",       "info"};

TEST(Help, IsACommandToo)
{
    const std::string all = lambent({"--help"}).output;
    EXPECT_EQ(lambent({"help"}).output, all);
    for (const std::string& command : commands) {
        EXPECT_NE(all.find("\n  " + command + " "), std::string::npos) << command;
        const Outcome help = lambent({"help", command});
        EXPECT_EQ(help.code, 0);
        EXPECT_EQ(help.error, "");
        EXPECT_EQ(help.output, lambent({command, "--help"}).output);
        EXPECT_NE(help.output.find("Everywhere:"), std::string::npos) << command;
    }
}

TEST(Help, FitsEightyColumns)
{
    std::vector<std::vector<std::string>> asked = {{"help"}};
    for (const std::string& command : commands)
        asked.push_back({"help", command});
    for (const auto& words : asked) {
        std::istringstream lines(lambent(words).output);
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(line.size(), 80u) << line;
    }
}

TEST(Help, OfPicturesIsGrouped)
{
    for (const char* command : {"render", "reference", "view", "serve"}) {
        const std::string help = lambent({"help", command}).output;
        std::size_t last = 0;
        for (const char* heading : {"\nLight:\n", "\nView and time:\n", "\nMaterials and built-in shapes:\n",
                                    "\nFrom light to pixels:\n"}) {
            const std::size_t at = help.find(heading);
            ASSERT_NE(at, std::string::npos) << command << heading;
            EXPECT_GT(at, last) << command << heading;
            last = at;
        }
        EXPECT_GT(help.find("  --env ENV"), help.find("\nLight:\n"));
        EXPECT_LT(help.find("  --env ENV"), help.find("\nView and time:\n"));
    }
}

struct Mistake {
    std::vector<std::string> words;
    int code;
    std::string said;
};

void expect_said(const Mistake& mistake)
{
    const Outcome outcome = lambent(mistake.words);
    EXPECT_EQ(outcome.code, mistake.code) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(mistake.said), std::string::npos) << outcome.error;
    EXPECT_EQ(outcome.output, "");
}

TEST(Help, NamesWhatWasProbablyMeant)
{
    for (const Mistake& mistake : std::vector<Mistake>{
             {{"rendre", "sphere", "-o", "x.png"}, 2, "no command 'rendre'; did you mean 'render'?"},
             {{"help", "bkae"}, 2, "did you mean 'bake'?"},
             {{"render", "sphere", "-o", "x.png", "--exposre", "2"}, 2, "did you mean '--exposure'?"},
             {{"render", "sphere", "-o", "x.png", "--exposre=2"}, 2, "no option '--exposre'; did you mean"},
             {{"render", "sphere", "--otput", "x.png"}, 2, "did you mean '--output'?"},
             {{"compare", "a.png", "b.png", "--max-filp", "1"}, 2, "did you mean '--max-flip'?"},
             {{"render", "sphere", "-o", "x.png", "--tone", "aecs"}, 2, "did you mean 'aces'?"},
             {{"render", "spehre", "-o", "x.png"},
              3,
              "spehre: no such file or built-in scene; did you mean 'sphere'?"},
             {{"reference", "taepot", "-o", "x.png"}, 3, "did you mean 'teapot'?"},
             {{"render", "sphere", "--env", "stduio", "-o", "x.png"},
              3,
              "environment; did you mean 'studio'?"},
             {{"reference", "sphere", "--env", "stduio", "-o", "x.png"}, 3, "did you mean 'studio'?"},
             {{"bake", "kitchn", "-o", "x.ktx2"}, 3, "did you mean 'kitchen'?"},
             {{"env", "kichen", "-o", "x.hdr"}, 2, "did you mean 'kitchen'?"},
         })
        expect_said(mistake);
}

TEST(Help, GuessesNothingWhereNothingIsNear)
{
    for (const Mistake& mistake :
         std::vector<Mistake>{{{"draw"}, 2, "there is no command 'draw'; lambent --help"},
                              {{"help", "render", "bake"}, 2, "one command at a time"},
                              {{"render", "x.glb", "-o", "x.png"}, 3, "x.glb: no such file"}}) {
        expect_said(mistake);
        EXPECT_EQ(lambent(mistake.words).error.find("did you mean"), std::string::npos);
    }
}

TEST(Help, OptionsFollowTheCommand)
{
    expect_said(
        {{"--threads", "1", "render", "sphere", "-o", "x.png"}, 2, "--threads: options follow the command"});
}

} // namespace
} // namespace lambent
