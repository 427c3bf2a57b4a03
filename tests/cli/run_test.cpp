// The program as its users meet it: what it writes, what it says, how it ends.
#include "tests/cli/lambent.h"

#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;

// One line, of the documented form, and nothing on standard output.
void expect_failure(const Outcome& outcome, int code)
{
    EXPECT_EQ(outcome.code, code) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_EQ(outcome.output, "");
}

TEST(Run, HelpAndVersion)
{
    const Outcome help = lambent({"--help"});
    EXPECT_EQ(help.code, 0);
    for (const char* command : {"render", "bake", "reference", "compare", "report", "env", "info"})
        EXPECT_NE(help.output.find(command), std::string::npos);
    EXPECT_EQ(lambent({"--version"}).output.rfind("lambent ", 0), 0u);
    EXPECT_EQ(lambent({"render", "--help"}).code, 0);
}

TEST(Run, EveryBuiltInSceneIsDrawnInEveryFormat)
{
    const Folder folder;
    int index = 0;
    for (const char* scene : {"sphere", "teapot", "plane", "report", "painted", "grid", "furnace"}) {
        const std::string path =
            folder.path(std::string(scene) +
                        std::vector{".png", ".jpg", ".exr", ".hdr"}[static_cast<std::size_t>(index++ % 4)]);
        const Outcome outcome = lambent({"render", scene, "-o", path, "--size", "96x54", "--samples", "8"});
        ASSERT_EQ(outcome.code, 0) << outcome.error;
        EXPECT_EQ(outcome.error, "");
        EXPECT_EQ(outcome.output, "");
        const image::ImageInfo info = image::inspect(path);
        EXPECT_EQ(info.width, 96);
        EXPECT_EQ(info.height, 54);
    }
    EXPECT_EQ(folder.names().size(), 7u);
}

TEST(Run, ThePngIsTheExrThroughTheReportsCurve)
{
    const Folder folder;
    const std::vector<std::string> common = {"--size", "64x36", "--samples", "8", "--exposure", "3"};
    for (const char* name : {"a.exr", "a.png"}) {
        std::vector<std::string> words = {"render", "teapot", "--env", "sky", "-o", folder.path(name)};
        words.insert(words.end(), common.begin(), common.end());
        ASSERT_EQ(lambent(words).code, 0);
    }
    const image::RadianceImage light = image::read_radiance(folder.path("a.exr"));
    const image::CodeImage codes = image::read_codes(folder.path("a.png"));
    for (std::size_t i = 0; i < 64 * 36; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double ec = 3.0 * static_cast<double>(light.values[3 * i + c]);
            const double code = 255.0 * std::pow(ec / (ec + 1.0), 1.0 / 2.2);
            ASSERT_LE(std::fabs(codes.bytes[4 * i + c] - code), 0.51);
        }
}

TEST(Run, TheSameCommandGivesTheSameBytesOnAnyNumberOfThreads)
{
    const Folder folder;
    std::string first;
    for (const char* threads : {"1", "2", "3"}) {
        const std::string path = folder.path(std::string(threads) + ".exr");
        ASSERT_EQ(lambent({"render", "report", "-o", path, "--size", "160x90", "--threads", threads}).code,
                  0);
        std::ifstream in(path, std::ios::binary);
        const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
        ASSERT_FALSE(bytes.empty());
        if (first.empty())
            first = bytes;
        EXPECT_EQ(bytes, first);
    }
}

TEST(Run, StatsAreOneJsonObject)
{
    const Folder folder;
    const Outcome outcome = lambent({"render", "grid", "-o", folder.path("g.png"), "--size", "64x36",
                                     "--stats", "json", "--threads", "1"});
    ASSERT_EQ(outcome.code, 0);
    const nlohmann::json stats = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(stats["backend"], "cpu");
    EXPECT_EQ(stats["triangles"], 70756);
    EXPECT_EQ(stats["width"], 64);
    EXPECT_TRUE(stats["device"].get<std::string>().ends_with(" 1 threads")) << stats["device"];
    double sum = 0.0;
    for (const auto& [stage, ms] : stats["times_ms"].items())
        sum += stage == "total" ? 0.0 : ms.get<double>();
    EXPECT_NEAR(sum, stats["times_ms"]["total"].get<double>(), 0.5);
}

TEST(Run, ATransparentPngHoldsTheCoverage)
{
    const Folder folder;
    ASSERT_EQ(
        lambent({"render", "sphere", "-o", folder.path("s.png"), "--size", "64x64", "--background", "none"})
            .code,
        0);
    const image::CodeImage codes = image::read_codes(folder.path("s.png"));
    EXPECT_EQ(codes.bytes[3], 0);
    EXPECT_EQ(codes.bytes[4 * (32 * 64 + 32) + 3], 255);
    EXPECT_GT(codes.bytes[4 * (32 * 64 + 32)], 20);
}

TEST(Run, LayersAreWrittenToLookAtAndToCompute)
{
    const Folder folder;
    ASSERT_EQ(lambent({"render", "report", "--model", "phong", "-o", folder.path("r.png"), "--size", "64x36",
                       "--layers", folder.path("layers")})
                  .code,
              0);
    for (const char* name : {"diffuse", "specular", "exponent", "normal", "depth", "mip_level",
                             "light_direct", "light_ambient", "light_specular", "light_background"})
        for (const char* extension : {".png", ".exr"})
            EXPECT_TRUE(std::filesystem::exists(folder.path("layers/") + name + extension)) << name;
}

TEST(Run, EnvironmentsAreWrittenAndReadBack)
{
    const Folder folder;
    for (const char* name : {"kitchen", "studio", "sky", "furnace"})
        for (const char* extension : {".hdr", ".exr"}) {
            const std::string path = folder.path(std::string(name) + extension);
            ASSERT_EQ(lambent({"env", name, "-o", path, "--size", "256x128"}).code, 0);
            const Outcome outcome =
                lambent({"render", "sphere", "--env", path, "-o", folder.path("x.png"), "--size", "32x18"});
            EXPECT_EQ(outcome.code, 0) << outcome.error;
            EXPECT_EQ(outcome.error, "");
        }
    const image::RadianceImage furnace = image::read_radiance(folder.path("furnace.exr"));
    for (const float v : furnace.values)
        ASSERT_EQ(v, 1.0f);
}

TEST(Run, InfoSaysWhatIsInAFile)
{
    const Folder folder;
    ASSERT_EQ(lambent({"env", "studio", "-o", folder.path("e.hdr"), "--size", "128x64"}).code, 0);
    const Outcome plain = lambent({"info", folder.path("e.hdr")});
    EXPECT_EQ(plain.code, 0);
    EXPECT_NE(plain.output.find("128"), std::string::npos);
    const nlohmann::json info =
        nlohmann::json::parse(lambent({"info", folder.path("e.hdr"), "--json"}).output);
    EXPECT_EQ(info["height"], 64);
    write_bytes(folder.path("m.gltf"), R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[]}],"scene":0})");
    const nlohmann::json scene =
        nlohmann::json::parse(lambent({"info", folder.path("m.gltf"), "--json"}).output);
    EXPECT_EQ(scene["triangles"], 0);
}

TEST(Run, AnEmptySceneIsItsBackground)
{
    const Folder folder;
    write_bytes(folder.path("m.gltf"), R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[]}],"scene":0})");
    const Outcome outcome = lambent(
        {"render", folder.path("m.gltf"), "--env", "furnace", "-o", folder.path("x.exr"), "--size", "16x9"});
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(image::read_radiance(folder.path("x.exr")).values[0], 1.0f);
}

// Pictures, warnings and all, are the same from the cache, and nothing is kept that was not asked for.
TEST(Run, EnvironmentsAreCached)
{
    const Folder folder;
    std::filesystem::remove_all(testing::cache_home());
    const std::string panorama = folder.path("sky.hdr");
    ASSERT_EQ(lambent({"env", "sky", "-o", panorama, "--size", "256x128"}).code, 0);
    const auto draw = [&](const std::string& name, std::vector<std::string> more) {
        more.insert(more.begin(), {"render", "sphere", "--env", panorama, "-o", folder.path(name), "--size",
                                   "48x32", "--stats", "json"});
        const Outcome outcome = lambent(more);
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        return nlohmann::json::parse(outcome.output)["environment_cached"].get<bool>();
    };
    EXPECT_FALSE(draw("a.exr", {"--no-cache"}));
    EXPECT_FALSE(std::filesystem::exists(testing::cache_home()));
    EXPECT_FALSE(draw("b.exr", {}));
    EXPECT_TRUE(draw("c.exr", {}));
    EXPECT_FALSE(draw("d.exr", {"--no-cache"}));
    for (const char* name : {"b.exr", "c.exr", "d.exr"})
        EXPECT_EQ(image::read_radiance(folder.path(name)).values,
                  image::read_radiance(folder.path("a.exr")).values);
    // Another content under the same name.
    ASSERT_EQ(lambent({"env", "studio", "-o", panorama, "--size", "256x128"}).code, 0);
    EXPECT_FALSE(draw("e.exr", {}));
    EXPECT_NE(image::read_radiance(folder.path("e.exr")).values,
              image::read_radiance(folder.path("a.exr")).values);
}

TEST(Run, UsageErrorsAreTwo)
{
    const Folder folder;
    expect_failure(lambent({}), 2);
    expect_failure(lambent({"bake", "none", "-o", folder.path("y")}), 2);
    expect_failure(lambent({"render", "sphere", "-o", folder.path("x.gif")}), 2);
    expect_failure(lambent({"render", "sphere", "-o", folder.path("x.png"), "--camera-node", "none"}), 2);
    expect_failure(lambent({"env", "kitchenette", "-o", folder.path("x.hdr")}), 2);
    EXPECT_TRUE(folder.names().empty());
}

TEST(Run, OutputsThatCannotBeWrittenAreFive)
{
    const Folder folder;
    expect_failure(lambent({"render", "sphere", "-o", folder.path("no/such/folder/x.png")}), 5);
    expect_failure(lambent({"env", "sky", "-o", folder.path("no/x.hdr")}), 5);
    write_bytes(folder.path("file"), "x");
    expect_failure(lambent({"render", "sphere", "-o", folder.path("file/x.png"), "--size", "8x8"}), 5);
    expect_failure(lambent({"render", "sphere", "-o", folder.path("x.png"), "--size", "8x8", "--layers",
                            folder.path("file")}),
                   5);
    std::filesystem::create_directory(folder.path("folder.png"));
    expect_failure(lambent({"render", "sphere", "-o", folder.path("folder.png"), "--size", "8x8"}), 5);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"file", "folder.png"}));
    // A layer that fails after the drawing takes the picture with it.
    std::filesystem::create_directories(folder.path("layers/normal.exr"));
    expect_failure(lambent({"render", "sphere", "-o", folder.path("x.png"), "--size", "8x8", "--layers",
                            folder.path("layers")}),
                   5);
    EXPECT_FALSE(std::filesystem::exists(folder.path("x.png")));
}

TEST(Run, WarningsAreLinesToo)
{
    const Folder folder;
    // 4x2 texels, flat, one of them with an absurd exponent.
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
    for (int i = 0; i < 8; ++i)
        hdr += i == 3 ? std::string("\xff\xff\xff\xff", 4) : std::string("\x80\x80\x80\x81", 4);
    write_bytes(folder.path("hot.hdr"), hdr);
    const Outcome outcome = lambent(
        {"render", "sphere", "--env", folder.path("hot.hdr"), "-o", folder.path("x.exr"), "--size", "16x9"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.error.rfind("lambent: warning: ", 0), 0u) << outcome.error;
    EXPECT_NE(outcome.error.find("1 of 8 texels"), std::string::npos) << outcome.error;
    EXPECT_LT(image::read_radiance(folder.path("x.exr")).values[0], 10.0f);
    const Outcome quiet = lambent({"render", "sphere", "--env", folder.path("hot.hdr"), "-o",
                                   folder.path("x.exr"), "--size", "16x9", "--quiet"});
    EXPECT_EQ(quiet.error, "");
}

} // namespace
} // namespace lambent
