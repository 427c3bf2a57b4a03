// `lambent reference` as its users meet it, also those who press Ctrl-C.
#include "tests/cli/lambent.h"

#include "image/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;

Outcome shell(const std::string& script)
{
    return testing::run_program("/bin/sh", {"-c", script});
}

const std::string program = LAMBENT_PROGRAM;

TEST(Reference, TracesThePictureThatRenderDraws)
{
    const Folder folder;
    const std::string traced = folder.path("traced.exr"), drawn = folder.path("drawn.exr");
    const std::vector<std::string> view = {"--env", "furnace", "--size", "72x72", "--camera", "0,0,0.8"};
    std::vector<std::string> trace = {"reference", "sphere",    "-o", traced,    "--spp",
                                      "256",       "--bounces", "0",  "--stats", "json"};
    std::vector<std::string> render = {"render", "sphere", "-o", drawn};
    trace.insert(trace.end(), view.begin(), view.end());
    render.insert(render.end(), view.begin(), view.end());
    const Outcome outcome = lambent(trace);
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    const nlohmann::json stats = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(stats["command"], "reference");
    EXPECT_EQ(stats["samples"], 256.0);
    EXPECT_GT(stats["error"].get<double>(), 0.0);
    EXPECT_GT(stats["times_ms"]["trace"].get<double>(), 0.0);
    ASSERT_EQ(lambent(render).code, 0);
    const nlohmann::json apart = nlohmann::json::parse(lambent({"compare", drawn, traced}).output);
    // The reference's own noise and little else.
    EXPECT_LT(apart["relative_rmse"].get<double>(), 0.05);
}

TEST(Reference, TakesRendersOptionsAndItsOwn)
{
    const Folder folder;
    const std::string out = folder.path("a.png"), variance = folder.path("v.exr");
    const Outcome outcome = lambent(
        {"reference", "report",    "-o",         out,          "--size", "48x27",     "--spp",
         "3",         "--bounces", "2",          "--model",    "phong",  "--samples", "7",
         "--aa",      "2",         "--exposure", "2",          "--tone", "aces",      "--env",
         "studio",    "--seed",    "5",          "--variance", variance, "--light",   "point:0,1,0,1,1,1",
         "--uniform"});
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(image::read_codes(out).width, 48);
    EXPECT_EQ(image::read_radiance(variance).height, 27);
}

TEST(Reference, StopsAtTheTime)
{
    const Folder folder;
    const Outcome outcome = lambent({"reference", "teapot", "-o", folder.path("a.exr"), "--env", "studio",
                                     "--size", "64x36", "--time", "0.3", "--stats", "json"});
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_GE(nlohmann::json::parse(outcome.output)["samples"].get<double>(), 1.0);
    EXPECT_LT(outcome.seconds, 20.0);
}

TEST(Reference, RefusesWhatMakesNoSense)
{
    const Folder folder;
    const std::string out = folder.path("a.exr");
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--spp", "0"},
                                                  {"--bounces", "-1"},
                                                  {"--noise", "0"},
                                                  {"--time", "-3"},
                                                  {"--spp", "many"},
                                                  {"--variance", folder.path("v.png")},
                                                  {"--layers", folder.path("l")},
                                                  {"--seed", "-1"}}) {
        std::vector<std::string> words = {"reference", "sphere", "-o", out, "--size", "8x8"};
        words.insert(words.end(), wrong.begin(), wrong.end());
        const Outcome outcome = lambent(words);
        EXPECT_EQ(outcome.code, 2) << wrong[0];
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    }
    EXPECT_EQ(lambent({"reference", folder.path("none.glb"), "-o", out}).code, 3);
    EXPECT_TRUE(folder.names().empty());
}

TEST(Reference, StoppedByCtrlCItWritesTheWholePicture)
{
    const Folder folder;
    const std::string out = folder.path("a.exr");
    const Outcome outcome = shell(program + " reference grid --env studio --size 320x180 --spp 1000000 -o " +
                                  out + " & p=$!; sleep 1.5; kill -INT $p; wait $p");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: warning: stopped early", 0), 0u) << outcome.error;
    const image::RadianceImage picture = image::read_radiance(out);
    EXPECT_EQ(picture.width, 320);
    for (int y = 0; y < 180; ++y) // the studio is nowhere black
        for (int x = 0; x < 320; ++x)
            ASSERT_GT(picture.pixel(x, y)[1], 0.0f) << x << ", " << y;
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(Reference, KilledItLeavesNothing)
{
    const Folder folder;
    shell(program + " reference grid --env studio --size 320x180 --spp 1000000 -o " + folder.path("a.exr") +
          " & p=$!; sleep 0.5; kill -KILL $p; wait $p");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Reference, OnAFullDiskItLeavesNothing)
{
    const Folder folder;
    // Files may not grow beyond a few kilobytes, as on a disk that is full.
    const Outcome outcome =
        shell("trap '' XFSZ; ulimit -f 8; exec " + program +
              " reference sphere --env studio --size 128x72 --spp 2 -o " + folder.path("a.exr"));
    EXPECT_EQ(outcome.code, 5) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
    EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace lambent
