// The command line as values.
#include "apps/options/arguments.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
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

TEST(Arguments, TheReportsPipelineIsItsOwn)
{
    const RenderArguments plain = render({"--model", "phong", "--pipeline", "light", "--exposure", "3"});
    EXPECT_FALSE(plain.settings.pipeline);
    EXPECT_EQ(plain.display.exposure, 3.0f);
    const RenderArguments whole =
        render({"--model", "phong", "--pipeline", "report", "--exposure", "70", "--contrast", "2"});
    ASSERT_TRUE(whole.settings.pipeline);
    EXPECT_EQ(whole.settings.pipeline->exposure, 70.0f);
    EXPECT_EQ(whole.settings.pipeline->contrast, 2.0f);
    EXPECT_TRUE(whole.settings.pipeline->linear);
    EXPECT_EQ(whole.settings.mip_level, draw::MipLevel::report);
    EXPECT_EQ(whole.settings.texel_transfer, draw::TexelTransfer::none);
    EXPECT_EQ(whole.settings.ambient_brightness, 2.0f);
    // What is drawn are codes already.
    EXPECT_EQ(whole.display.exposure, 1.0f);
    EXPECT_EQ(whole.display.contrast, 1.0f);
    EXPECT_EQ(whole.display.tone, display::Tone::linear);
    EXPECT_FALSE(whole.display.encode);
    const RenderArguments other = render(
        {"--model", "phong", "--pipeline", "report", "--space", "nonlinear", "--ambient-brightness", "1"});
    EXPECT_FALSE(other.settings.pipeline->linear);
    EXPECT_EQ(other.settings.ambient_brightness, 1.0f);
    const auto refused = [](std::vector<const char*> more) {
        std::vector<const char*> words = {"render", "sphere", "-o", "x.png", "--pipeline", "report"};
        words.insert(words.end(), more.begin(), more.end());
        return refusal(words);
    };
    EXPECT_EQ(refused({}), "--pipeline report: only with --model phong");
    EXPECT_NE(refused({"--model", "phong", "--mip-level", "matched"}), "");
    EXPECT_NE(refused({"--model", "phong", "--tone", "agx"}), "");
    EXPECT_NE(refusal({"reference", "sphere", "-o", "x.png", "--pipeline", "report"}), "");
}

TEST(Arguments, SplitSumIsFewSamplesWhateverTheirNumber)
{
    EXPECT_EQ(render({"--ibl", "split-sum"}).settings.samples, draw::split_sum_samples);
    EXPECT_EQ(render({"--samples", "100", "--ibl", "split-sum"}).settings.samples, draw::split_sum_samples);
    EXPECT_EQ(render({"--samples", "100", "--ibl", "sampled"}).settings.samples, 100);
}

TEST(Arguments, OneRoughnessIsForGgxAlone)
{
    EXPECT_FALSE(render({}).settings.roughness_override);
    EXPECT_EQ(render({"--roughness", "0.25"}).settings.roughness_override, 0.25f);
    EXPECT_EQ(render({"--model", "ggx", "--roughness", "0"}).settings.roughness_override, 0.0f);
    const auto reference =
        std::get<ReferenceArguments>(parse({"reference", "sphere", "-o", "x.exr", "--roughness", "1"}));
    EXPECT_EQ(reference.picture.settings.roughness_override, 1.0f);
    const auto served = std::get<ServeArguments>(parse({"serve", "sphere", "--roughness", "0.5"}));
    EXPECT_EQ(served.start.picture.settings.roughness_override, 0.5f);
    EXPECT_EQ(served.start.given.words("roughness"), std::vector<std::string>{"0.5"});
    EXPECT_NE(render_refusal({"--model", "phong", "--roughness", "0.5"}).find("--alpha"), std::string::npos);
}

TEST(Arguments, ATargetNeedsADistance)
{
    const RenderArguments a = render({"--camera", "10,20,3", "--target", "-1,2,-3"});
    EXPECT_EQ(a.target, glm::dvec3(-1.0, 2.0, -3.0));
    EXPECT_EQ(render({"--camera", "10,20,3", "--target", "4500000.25,0.1,100000000.125"}).target,
              glm::dvec3(4500000.25, 0.1, 100000000.125));
    EXPECT_FALSE(render({"--camera", "10,20,3"}).target);
    EXPECT_NE(render_refusal({"--camera", "10,20", "--target", "1,2,3"}), "");
    EXPECT_NE(render_refusal({"--target", "1,2,3"}), "");
    EXPECT_NE(render_refusal({"--camera", "10,20,3", "--target", "1,2"}), "");
}

TEST(Arguments, AMomentIsOneOfAFiles)
{
    const RenderArguments a = std::get<RenderArguments>(
        parse({"render", "a.glb", "-o", "a.png", "--animation", "walk", "--moment", "1.25"}));
    EXPECT_EQ(a.animation, "walk");
    EXPECT_EQ(a.moment, 1.25);
    EXPECT_FALSE(render({}).moment.has_value());
    for (const char* moment : {"-1", "nan", "inf", "x", "1s"})
        EXPECT_EQ(refusal({"render", "a.glb", "-o", "a.png", "--moment", moment}).find("--moment"), 0u)
            << moment;
    const auto start =
        std::get<ServeArguments>(parse({"serve", "a.glb", "--animation", "2", "--moment", "3"}));
    EXPECT_EQ(start.start.given.words("animation"), std::vector<std::string>{"2"});
    EXPECT_EQ(start.start.given.words("moment"), std::vector<std::string>{"3"});
}

TEST(Arguments, DefaultsAreTheContracts)
{
    const RenderArguments a = render({});
    EXPECT_EQ(a.settings.width, 1280);
    EXPECT_EQ(a.settings.height, 720);
    EXPECT_EQ(a.settings.samples, 40);
    EXPECT_EQ(a.settings.edge_samples, 24);
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
                                      "--mip-level",
                                      "report",
                                      "--no-energy-compensation",
                                      "--density",
                                      "0.5",
                                      "--dither",
                                      "--alpha",
                                      "15625",
                                      "--kd",
                                      "0.1,0.2,0.3",
                                      "--ks",
                                      "0.4,0.5,0.6",
                                      "--ibl",
                                      "sampled",
                                      "--samples",
                                      "64",
                                      "--ambient-brightness",
                                      "2",
                                      "--aa",
                                      "8",
                                      "--light",
                                      "directional:90,30,1,2,3",
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
    constexpr double degree = std::numbers::pi / 180.0;
    EXPECT_EQ(a.scene, "sphere");
    EXPECT_EQ(a.output, "x.png");
    EXPECT_EQ(a.environment, "furnace");
    EXPECT_EQ(a.settings.width, 64);
    EXPECT_EQ(a.settings.height, 32);
    ASSERT_TRUE(a.orbit.has_value());
    EXPECT_NEAR(a.orbit->azimuth, -30.0 * degree, 1e-6);
    EXPECT_NEAR(a.orbit->elevation, 20.0 * degree, 1e-6);
    EXPECT_EQ(a.orbit->distance, 2.5f);
    EXPECT_EQ(a.camera_node, "");
    EXPECT_NEAR(a.vertical_fov, 60.0 * degree, 1e-6);
    EXPECT_NEAR(a.settings.environment_rotation, 90.0 * degree, 1e-6);
    EXPECT_EQ(a.settings.background.kind, draw::Background::Kind::blurred);
    EXPECT_EQ(a.settings.background.roughness, 0.25f);
    EXPECT_EQ(a.display.exposure, 7000.0f);
    EXPECT_EQ(a.display.contrast, 1.5f);
    EXPECT_EQ(a.display.tone, display::Tone::agx);
    EXPECT_FALSE(a.display.encode);
    EXPECT_TRUE(a.display.dither);
    EXPECT_EQ(a.settings.texel_transfer, draw::TexelTransfer::none);
    EXPECT_EQ(a.settings.model, draw::Model::phong);
    EXPECT_EQ(a.settings.mip_level, draw::MipLevel::report);
    EXPECT_FALSE(a.settings.energy_compensation);
    EXPECT_EQ(a.builtin.density, 0.5f);
    EXPECT_EQ(a.builtin.exponent, 15625.0f);
    EXPECT_EQ(a.builtin.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(a.builtin.specular, glm::vec3(0.4f, 0.5f, 0.6f));
    EXPECT_EQ(a.settings.samples, 64);
    EXPECT_EQ(a.settings.ambient_brightness, 2.0f);
    EXPECT_EQ(a.settings.edge_samples, 8);
    ASSERT_EQ(a.settings.lights.size(), 2u);
    ASSERT_EQ(a.light_places.size(), 2u);
    const scene::Light &sun = a.settings.lights[0], &lamp = a.settings.lights[1];
    EXPECT_EQ(sun.kind, scene::LightKind::directional);
    // From azimuth 90, +X, and 30 degrees up it travels to -X and down.
    EXPECT_NEAR(sun.direction.x, -std::sqrt(0.75), 1e-6);
    EXPECT_NEAR(sun.direction.y, -0.5, 1e-6);
    EXPECT_NEAR(sun.direction.z, 0.0, 1e-6);
    EXPECT_EQ(sun.intensity, glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(lamp.kind, scene::LightKind::point);
    EXPECT_EQ(lamp.position, glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(lamp.intensity, glm::vec3(4.0f, 5.0f, 6.0f));
    EXPECT_EQ(a.common.threads, 1);
    EXPECT_TRUE(a.common.stats_json);
    EXPECT_EQ(a.common.verbosity, Verbosity::quiet);
    EXPECT_EQ(a.layers, "out");
}

TEST(Arguments, NamesMeanWhatTheySay)
{
    using display::Tone;
    for (const auto& [word, tone] : {std::pair("reinhard", Tone::reinhard),
                                     {"neutral", Tone::neutral},
                                     {"aces", Tone::aces},
                                     {"agx", Tone::agx},
                                     {"linear", Tone::linear}})
        EXPECT_EQ(render({"--tone", word}).display.tone, tone) << word;
    EXPECT_EQ(render({"--model", "ggx"}).settings.model, draw::Model::ggx);
    EXPECT_EQ(render({"--mip-level", "matched"}).settings.mip_level, draw::MipLevel::matched);
    EXPECT_TRUE(render({"--space", "linear"}).display.encode);
    EXPECT_EQ(render({"--camera-node", "front"}).camera_node, "front");
    EXPECT_EQ(render({"--verbose"}).common.verbosity, Verbosity::verbose);
    EXPECT_TRUE(render({}).settings.energy_compensation);
    EXPECT_FALSE(render({}).display.dither);
    // From the front, a quarter around, above.
    const glm::vec3 front = render({"--light", "directional:0,0,1,1,1"}).settings.lights[0].direction;
    EXPECT_NEAR(front.z, -1.0, 1e-6);
    const glm::vec3 above = render({"--light", "directional:0,90,1,1,1"}).settings.lights[0].direction;
    EXPECT_NEAR(above.y, -1.0, 1e-6);
}

TEST(Arguments, PhongDecodesTexelsAsTheReport)
{
    EXPECT_EQ(render({"--model", "phong"}).settings.texel_transfer, draw::TexelTransfer::power_2_2);
}

TEST(Arguments, BackgroundsAndColours)
{
    EXPECT_EQ(render({"--background", "none"}).settings.background.kind, draw::Background::Kind::none);
    EXPECT_EQ(render({"--background", "0.5,1,2"}).settings.background.color, glm::vec3(0.5f, 1.0f, 2.0f));
    EXPECT_EQ(render({"--background", "0.5,1,2"}).settings.background.kind, draw::Background::Kind::color);
    EXPECT_EQ(render({"--background", "env"}).settings.background.kind, draw::Background::Kind::environment);
}

TEST(Arguments, ABakesDefaultsAreTheContracts)
{
    const BakeArguments a = std::get<BakeArguments>(parse({"bake", "x.hdr", "-o", "folder"}));
    EXPECT_EQ(a.environment, "x.hdr");
    EXPECT_EQ(a.output, "folder");
    EXPECT_FALSE(a.one_file);
    EXPECT_EQ(a.options.size, 256);
    EXPECT_EQ(a.options.lobe, environment::BakeLobe::ggx);
    EXPECT_EQ(a.options.mapping, environment::RoughnessMapping::linear);
    EXPECT_EQ(a.options.error, 0.01);
    EXPECT_EQ(a.format, BakeFormat::ktx2);
    EXPECT_EQ(a.texels, image::TexelFormat::half4);
    EXPECT_FALSE(a.zstd || a.mirrored);
    EXPECT_EQ(BakeArguments::usual_table_size, 128);
    const BakeArguments b = std::get<BakeArguments>(
        parse({"bake", "sky", "-o", "a.DDS", "--irradiance", "sh", "--lut", "64", "--samples", "256"}));
    EXPECT_TRUE(b.one_file);
    EXPECT_EQ(b.format, BakeFormat::dds);
    EXPECT_EQ(b.irradiance_size, 0);
    EXPECT_EQ(b.table_size, 64);
    EXPECT_NEAR(b.options.error, 0.02, 1e-12);
}

TEST(Arguments, BouncesGoWithWhatCanDrawThem)
{
    EXPECT_EQ(render({}).settings.bounces, 8);
    EXPECT_EQ(render({"--bounces", "0"}).settings.bounces, 0);
    EXPECT_EQ(render({}).settings.passes, 2);
    const RenderArguments a = render({"--bounces", "8", "--passes", "5", "--backend", "cpu"});
    EXPECT_EQ(a.settings.bounces, 8);
    EXPECT_EQ(a.settings.passes, 5);
    const auto why = [](std::initializer_list<const char*> words) {
        std::vector<const char*> all = {"render", "sphere", "-o", "x.png"};
        all.insert(all.end(), words);
        return refusal(all);
    };
    for (const std::initializer_list<const char*>& words :
         {std::initializer_list<const char*>{"--bounces", "1", "--backend", "vulkan"},
          {"--backend", "vulkan"}})
        EXPECT_NE(why(words).find("--backend cpu or --bounces 0"), std::string::npos);
    // What only the report draws is without shadows, as the report is.
    EXPECT_EQ(render({"--ambient-brightness", "2"}).settings.bounces, 0);
    EXPECT_EQ(render({"--model", "phong", "--mip-level", "report"}).settings.bounces, 0);
    EXPECT_EQ(render({"--model", "phong", "--pipeline", "report"}).settings.bounces, 0);
    EXPECT_NE(why({"--bounces", "0", "--passes", "3"}).find("--passes: only with --bounces"),
              std::string::npos);
    EXPECT_NE(why({"--bounces", "0", "--error", "0.1"}).find("--error: only with --bounces"),
              std::string::npos);
    EXPECT_NE(why({"--bounces", "0", "--time", "3"}).find("--time: only with --bounces"), std::string::npos);
    EXPECT_NE(why({"--bounces", "1", "--passes", "3", "--time", "3"}).find("--passes"), std::string::npos);
    EXPECT_NE(why({"--bounces", "1", "--passes", "3", "--error", "0.1"}).find("--passes"), std::string::npos);
    EXPECT_NE(why({"--bounces", "1", "--error", "0.1", "--no-audit"}).find("--no-audit"), std::string::npos);
    EXPECT_EQ(render({"--bounces", "1", "--error", "0.1", "--time", "5"}).seconds, 5.0);
    EXPECT_NE(why({"--bounces", "1", "--ambient-brightness", "2"}).find("--ambient-brightness"),
              std::string::npos);
    EXPECT_NE(why({"--model", "phong", "--bounces", "1", "--mip-level", "report"}).find("--mip-level"),
              std::string::npos);
    EXPECT_NE(why({"--model", "phong", "--bounces", "1", "--pipeline", "report"}).find("--bounces"),
              std::string::npos);
}

TEST(Arguments, NonsenseIsRefusedInOneLine)
{
    EXPECT_NE(refusal({"frobnicate"}).find("frobnicate"), std::string::npos);
    EXPECT_NE(refusal({"render-all", "x.hdr", "-o", "y"}).find("render-all"), std::string::npos);
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
                                                       {"--roughness", "1.01"},
                                                       {"--roughness", "-0.1"},
                                                       {"--roughness", "nan"},
                                                       {"--roughness", "0.5", "--model", "phong"},
                                                       {"--unknown"},
                                                       {"--quiet", "--verbose"},
                                                       {"--camera", "1,2", "--camera-node", "x"},
                                                       {"--density", "100"},
                                                       {"--animation", "walk"},
                                                       {"--moment", "1"},
                                                       {"extra"},
                                                       {"--alpha", "0", "--model", "phong"},
                                                       {"--alpha", "2e6", "--model", "phong"}};
    for (const auto& words : bad)
        EXPECT_NE(render_refusal(words).find(words[0]), std::string::npos)
            << words[0] << ' ' << (words.size() > 1 ? words[1] : "") << ": " << render_refusal(words);
}

TEST(Arguments, HelpNamesEveryOption)
{
    const std::string help = std::get<PrintText>(parse({"render", "--help"})).text;
    for (const char* option :
         {"--env",        "--size",     "--camera",   "--fov",   "--camera-node", "--env-rotation",
          "--background", "--exposure", "--contrast", "--tone",  "--space",       "--model",
          "--alpha",      "--kd",       "--ks",       "--ibl",   "--samples",     "--ambient-brightness",
          "--animation",  "--moment",   "--aa",       "--light", "--backend",     "--threads",
          "--layers",     "--stats",    "--no-cache", "--quiet", "--verbose",     "--help",
          "--roughness"})
        EXPECT_NE(help.find(option), std::string::npos) << option;
    EXPECT_NE(std::get<PrintText>(parse({"--version"})).text.find("lambent 0."), std::string::npos);
}

TEST(Arguments, Environments)
{
    const auto a =
        std::get<EnvArguments>(parse({"env", "sky", "-o", "s.hdr", "--size", "2048x1024", "--sun", "90,45"}));
    EXPECT_EQ(a.name, "sky");
    EXPECT_EQ(a.output, "s.hdr");
    EXPECT_EQ(a.builtin.width, 2048);
    EXPECT_NEAR(a.builtin.sun_azimuth, std::numbers::pi / 2.0, 1e-6);
    EXPECT_NEAR(a.builtin.sun_elevation, std::numbers::pi / 4.0, 1e-6);
    EXPECT_EQ(refusal({"env", "sky", "-o", "s.hdr", "--size", "100x100"}).find("--size: "), 0u);
    EXPECT_EQ(
        std::get<EnvArguments>(parse({"env", "sky", "-o", "s.hdr", "--turbidity", "3.5"})).builtin.turbidity,
        3.5f);
    for (const char* haze : {"1", "11", "thick"})
        EXPECT_EQ(refusal({"env", "sky", "-o", "s.hdr", "--turbidity", haze}).find("--turbidity: "), 0u)
            << haze;
    for (const char* sun : {"0,-90", "0,91", "0,10,3"})
        EXPECT_EQ(refusal({"env", "sky", "-o", "s.hdr", "--sun", sun}).find("--sun: "), 0u) << sun;
}

} // namespace
} // namespace lambent::cli
