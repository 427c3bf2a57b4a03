// The command line as values.
#include "apps/cli/arguments.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace lambent::cli {
namespace {

Arguments parse(std::vector<const char*> words)
{
    words.insert(words.begin(), "lambent");
    return parse_arguments(static_cast<int>(words.size()), words.data());
}

RenderArguments render(std::vector<const char*> words)
{
    words.insert(words.begin(), {"render", "sphere", "-o", "x.png"});
    return std::get<RenderArguments>(parse(std::move(words)));
}

// The line with which a command line is refused; empty if it is taken.
std::string refusal(std::vector<const char*> words)
{
    try {
        parse(std::move(words));
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::usage);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
}

std::string render_refusal(std::vector<const char*> words)
{
    words.insert(words.begin(), {"render", "sphere", "-o", "x.png"});
    return refusal(std::move(words));
}

TEST(Arguments, DefaultsAreTheContracts)
{
    const RenderArguments a = render({});
    EXPECT_EQ(a.settings.width, 1280);
    EXPECT_EQ(a.settings.height, 720);
    EXPECT_EQ(a.settings.samples, 40);
    EXPECT_EQ(a.settings.edge_samples, 4);
    EXPECT_EQ(a.settings.model, draw::Model::ggx);
    EXPECT_EQ(a.settings.ambient_brightness, 1.0f);
    EXPECT_EQ(a.display.exposure, 1.0f);
    EXPECT_EQ(a.display.contrast, 1.0f);
    EXPECT_EQ(a.display.tone, display::Tone::reinhard);
    EXPECT_NEAR(a.vertical_fov, std::numbers::pi / 4.0, 1e-6);
    EXPECT_FALSE(a.orbit.has_value());
    EXPECT_EQ(a.settings.texel_transfer, draw::TexelTransfer::srgb);
}

TEST(Arguments, EveryOptionOfTheContractIsTaken)
{
    const RenderArguments a = render({"--env",
                                      "furnace",
                                      "--size",
                                      "64x32",
                                      "--camera",
                                      "-30,20,2.5",
                                      "--fov",
                                      "60",
                                      "--env-rotation",
                                      "90",
                                      "--background",
                                      "blur:0.25",
                                      "--exposure",
                                      "7000",
                                      "--contrast",
                                      "1.5",
                                      "--tone",
                                      "agx",
                                      "--space",
                                      "nonlinear",
                                      "--model",
                                      "phong",
                                      "--alpha",
                                      "15625",
                                      "--kd",
                                      "0.1,0.2,0.3",
                                      "--ks",
                                      "1,1,1",
                                      "--ibl",
                                      "sampled",
                                      "--samples",
                                      "64",
                                      "--ambient-brightness",
                                      "2",
                                      "--aa",
                                      "8",
                                      "--light",
                                      "directional:90,0,1,2,3",
                                      "--light",
                                      "point:1,2,3,4,5,6",
                                      "--backend",
                                      "cpu",
                                      "--threads",
                                      "1",
                                      "--layers",
                                      "out",
                                      "--stats",
                                      "json",
                                      "--no-cache",
                                      "--quiet"});
    EXPECT_EQ(a.environment, "furnace");
    EXPECT_EQ(a.settings.width, 64);
    EXPECT_NEAR(a.orbit->azimuth, -std::numbers::pi / 6.0, 1e-6);
    EXPECT_EQ(a.orbit->distance, 2.5f);
    EXPECT_NEAR(a.settings.environment_rotation, std::numbers::pi / 2.0, 1e-6);
    EXPECT_EQ(a.settings.background.kind, draw::Background::Kind::blurred);
    EXPECT_EQ(a.settings.background.roughness, 0.25f);
    EXPECT_EQ(a.display.exposure, 7000.0f);
    EXPECT_FALSE(a.display.encode);
    EXPECT_EQ(a.settings.texel_transfer, draw::TexelTransfer::none);
    EXPECT_EQ(a.builtin.exponent, 15625.0f);
    EXPECT_EQ(a.builtin.diffuse->b, 0.3f);
    EXPECT_EQ(a.settings.samples, 64);
    ASSERT_EQ(a.settings.lights.size(), 2u);
    EXPECT_EQ(a.settings.lights[0].kind, scene::LightKind::directional);
    EXPECT_NEAR(a.settings.lights[0].direction.x, -1.0f, 1e-6f); // from azimuth 90, +X, it travels to -X
    EXPECT_EQ(a.settings.lights[0].intensity.g, 2.0f);
    EXPECT_EQ(a.settings.lights[1].position.z, 3.0f);
    EXPECT_EQ(a.settings.lights[1].intensity.r, 4.0f);
    EXPECT_EQ(a.common.threads, 1);
    EXPECT_TRUE(a.common.stats_json);
    EXPECT_EQ(a.common.verbosity, Verbosity::quiet);
    EXPECT_EQ(a.layers, "out");
}

TEST(Arguments, PhongDecodesTexelsAsTheReport)
{
    EXPECT_EQ(render({"--model", "phong"}).settings.texel_transfer, draw::TexelTransfer::power_2_2);
}

TEST(Arguments, BackgroundsAndColours)
{
    EXPECT_EQ(render({"--background", "none"}).settings.background.kind, draw::Background::Kind::none);
    EXPECT_EQ(render({"--background", "0.5,1,2"}).settings.background.color.b, 2.0f);
}

TEST(Arguments, NonsenseIsRefusedInOneLine)
{
    EXPECT_NE(refusal({"frobnicate"}).find("frobnicate"), std::string::npos);
    EXPECT_NE(refusal({"bake", "x.hdr", "-o", "y"}).find("bake"), std::string::npos);
    EXPECT_FALSE(refusal({}).empty());
    EXPECT_FALSE(refusal({"render"}).empty());
    EXPECT_FALSE(refusal({"render", "sphere"}).empty());
    EXPECT_FALSE(refusal({"render", "sphere", "-o"}).empty());
    EXPECT_FALSE(refusal({"env", "sky"}).empty());
    const std::vector<std::vector<const char*>> bad = {{"--size", "0x10"},
                                                       {"--size", "10"},
                                                       {"--size", "99999x10"},
                                                       {"--size", "60000x60000"},
                                                       {"--size", "1e9x1"},
                                                       {"--size", "-5x5"},
                                                       {"--size", "5x5x5"},
                                                       {"--camera", "1"},
                                                       {"--camera", "1,91"},
                                                       {"--camera", "1,2,0"},
                                                       {"--camera", "a,b"},
                                                       {"--camera", "1,,2"},
                                                       {"--fov", "180"},
                                                       {"--fov", "0"},
                                                       {"--exposure", "0"},
                                                       {"--exposure", "nan"},
                                                       {"--exposure", "inf"},
                                                       {"--exposure", "1e400"},
                                                       {"--exposure", ""},
                                                       {"--contrast", "-1"},
                                                       {"--tone", "film"},
                                                       {"--space", "log"},
                                                       {"--model", "0"},
                                                       {"--samples", "0"},
                                                       {"--samples", "1.5"},
                                                       {"--samples", "99999999"},
                                                       {"--aa", "0"},
                                                       {"--background", "red"},
                                                       {"--background", "blur:2"},
                                                       {"--background", "1,2"},
                                                       {"--light", "sun:1,2,3"},
                                                       {"--light", "point:1,2,3"},
                                                       {"--light", "point:0,0,0,-1,0,0"},
                                                       {"--threads", "0"},
                                                       {"--backend", "cuda"},
                                                       {"--stats", "xml"},
                                                       {"--kd", "1,1,1"},
                                                       {"--unknown"},
                                                       {"--quiet", "--verbose"},
                                                       {"--camera", "1,2", "--camera-node", "x"},
                                                       {"--density", "100"},
                                                       {"extra"},
                                                       {"--alpha", "0", "--model", "phong"},
                                                       {"--alpha", "2e6", "--model", "phong"}};
    for (const auto& words : bad)
        EXPECT_FALSE(render_refusal(words).empty()) << words[0] << ' ' << (words.size() > 1 ? words[1] : "");
}

TEST(Arguments, HelpNamesEveryOption)
{
    const std::string help = std::get<PrintText>(parse({"render", "--help"})).text;
    for (const char* option :
         {"--env",        "--size",     "--camera",   "--fov",     "--camera-node", "--env-rotation",
          "--background", "--exposure", "--contrast", "--tone",    "--space",       "--model",
          "--alpha",      "--kd",       "--ks",       "--ibl",     "--samples",     "--ambient-brightness",
          "--aa",         "--light",    "--backend",  "--threads", "--layers",      "--stats",
          "--no-cache",   "--quiet",    "--verbose",  "--help"})
        EXPECT_NE(help.find(option), std::string::npos) << option;
    EXPECT_NE(std::get<PrintText>(parse({"--version"})).text.find("lambent 0."), std::string::npos);
}

TEST(Arguments, Environments)
{
    const auto a =
        std::get<EnvArguments>(parse({"env", "sky", "-o", "s.hdr", "--size", "2048x1024", "--sun", "90,45"}));
    EXPECT_EQ(a.builtin.width, 2048);
    EXPECT_NEAR(a.builtin.sun_elevation, std::numbers::pi / 4.0, 1e-6);
    EXPECT_FALSE(refusal({"env", "sky", "-o", "s.hdr", "--size", "100x100"}).empty());
    for (const char* sun : {"0,-90", "0,91", "0,10,3"})
        EXPECT_EQ(refusal({"env", "sky", "-o", "s.hdr", "--sun", sun}).find("--sun: "), 0u) << sun;
}

} // namespace
} // namespace lambent::cli
