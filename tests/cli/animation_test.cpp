// `--animation` and `--moment` as their users meet them.
#include "tests/cli/lambent.h"
#include "tests/scene/sliding_model.h"

#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace lambent {
namespace {

using nlohmann::json;
using testing::Folder;
using testing::Outcome;

std::string write_model(const Folder& folder)
{
    const std::string path = folder.path("m.glb");
    const auto bytes = scene::test::sliding_model();
    write_bytes(path, std::string(bytes.begin(), bytes.end()));
    return path;
}

// Where the shape's pixels are on average, in pixels; the picture has no background.
struct Middle {
    double x = 0.0, y = 0.0;
};

Middle middle_of(const Folder& folder, const std::string& command, const std::vector<std::string>& more)
{
    std::vector<std::string> words = {command, folder.path("m.glb"), "--env", "furnace", "--camera",
                                      "0,0,5", "--background",       "none",  "--size",  "64x64",
                                      "-o",    folder.path("x.png")};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = lambent(words);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    const image::CodeImage picture = image::read_codes(folder.path("x.png"));
    Middle sum;
    double count = 0.0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (picture.bytes[static_cast<std::size_t>(4 * (64 * y + x) + 3)] > 127)
                sum.x += x, sum.y += y, count += 1.0;
    EXPECT_GT(count, 20.0);
    return {sum.x / count, sum.y / count};
}

// 64 pixels show 2 * 5 m * tan(22.5 degrees): a metre is 15.45 of them.
constexpr double metre = 15.45;

TEST(Animation, EveryMomentIsDrawnFromOnePlace)
{
    const Folder folder;
    write_model(folder);
    const Middle rest = middle_of(folder, "render", {});
    const auto expect_moved = [&](const std::vector<std::string>& more, double x, double y) {
        const Middle moved = middle_of(folder, "render", more);
        EXPECT_NEAR(moved.x - rest.x, x * metre, 1.0) << more.back();
        EXPECT_NEAR(moved.y - rest.y, y * metre, 1.0) << more.back();
    };
    expect_moved({"--moment", "1"}, 0.5, 0.0);
    expect_moved({"--moment", "100"}, 1.0, 0.0);
    expect_moved({"--animation", "sink"}, 0.0, 0.0);
    expect_moved({"--animation", "sink", "--moment", "3"}, 0.0, 0.75);
    expect_moved({"--animation", "1", "--moment", "3"}, 0.0, 0.75);
    const Middle reference = middle_of(folder, "reference", {"--moment", "1", "--spp", "4"});
    EXPECT_NEAR(reference.x - rest.x, 0.5 * metre, 1.0);
}

TEST(Animation, WhatIsNotThereIsBadUsage)
{
    const Folder folder;
    const std::string model = write_model(folder), still = folder.path("still.gltf");
    write_bytes(still, R"({"asset":{"version":"2.0"}})");
    const auto refusal = [&](const std::string& scene, const std::vector<std::string>& more) {
        std::vector<std::string> words = {"render", scene, "-o", folder.path("x.png")};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = lambent(words);
        EXPECT_EQ(outcome.code, 2) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
        return outcome.error;
    };
    EXPECT_EQ(refusal(model, {"--animation", "run"}),
              "lambent: error: --animation: " + model + " has no animation 'run' (it has slide, sink)\n");
    refusal(model, {"--animation", "2"});
    refusal(model, {"--animation", "-1"});
    EXPECT_EQ(refusal(still, {"--moment", "1"}),
              "lambent: error: --moment: " + still + " has no animations\n");
    refusal(still, {"--animation", "0"});
    EXPECT_FALSE(std::filesystem::exists(folder.path("x.png")));
}

TEST(Animation, InfoListsThem)
{
    const Folder folder;
    const std::string model = write_model(folder);
    const json info = json::parse(lambent({"info", model, "--json"}).output);
    EXPECT_EQ(info["animations"],
              json({{{"name", "slide"}, {"seconds", 2.0}}, {{"name", "sink"}, {"seconds", 4.0}}}));
    EXPECT_EQ(info["meshes"], 1);
    EXPECT_NE(lambent({"info", model}).output.find("slide, 2 s; sink, 4 s\n"), std::string::npos);
}

} // namespace
} // namespace lambent
