// Wishes as command lines: what is shown can be typed.
#include "apps/viewer/view_request.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::viewer {
namespace {

TEST(ViewRequest, TheCommandSaysAllThatIsNotUsual)
{
    ViewRequest request = default_request("my model.glb", "-sky.hdr");
    request.eye = OrbitCamera(10.0, -20.0);
    set_size(request, 640, 360);
    set_value(request.asked, "tone", "agx");
    set_lights(request, {"point:1,2,3,4,5,6"});
    EXPECT_EQ(
        command_of(request, "out.png"),
        "lambent render 'my model.glb' --env ./-sky.hdr --size 640x360 --camera 10,-20 --tone agx --light "
        "point:1,2,3,4,5,6 -o out.png");
    const cli::RenderArguments arguments = arguments_of(request);
    EXPECT_EQ(arguments.scene, "my model.glb");
    EXPECT_EQ(arguments.environment, "./-sky.hdr");
    EXPECT_EQ(arguments.settings.lights.size(), 1u);
    EXPECT_EQ(arguments.display.tone, display::Tone::agx);
}

TEST(ViewRequest, AnAnimationIsCalledByWhatNamesItAlone)
{
    using Names = std::vector<scene::AnimationInfo>;
    const auto word_of = [](const Names& names, int number) {
        ViewRequest request = default_request("walker.glb", "kitchen");
        animate(request, names, number);
        request.moment = 0.5;
        const cli::RenderArguments arguments = arguments_of(request);
        EXPECT_EQ(arguments.animation, request.asked.animation);
        EXPECT_EQ(arguments.moment, 0.5);
        EXPECT_EQ(animation_of(request, names), number);
        return request.asked.animation;
    };
    EXPECT_EQ(word_of({{"-walk", 1}, {"run", 1}}, 0), "-walk");
    EXPECT_EQ(word_of({{"walk", 1}, {"walk", 1}}, 1), "1");
    EXPECT_EQ(word_of({{"walk", 1}, {std::string("x\0y", 3), 1}}, 1), "1");
    EXPECT_EQ(word_of({{"", 1}, {"run", 1}}, 0), "0");
    ViewRequest request = default_request("walker.glb", "kitchen");
    animate(request, {{"walk", 1}}, 0);
    for (const double none : {1.0, 0.5, std::nan("")})
        EXPECT_THROW(animate(request, {{"walk", 1}}, none), Error);
    EXPECT_EQ(request.asked.animation, "walk"); // as it was
    request.asked.scene = "sphere";
    EXPECT_FALSE(arguments_of(request).moment.has_value());
}

TEST(ViewRequest, LightsAreCheckedAndCounted)
{
    ViewRequest request = default_request("grid", "kitchen");
    EXPECT_THROW(set_lights(request, {"spot:1"}), Error);
    EXPECT_THROW(set_lights(request, {"point:1,2,3,-4,5,6"}), Error);
    EXPECT_THROW(set_lights(request, std::vector<std::string>(most_lights + 1, "point:1,2,3,4,5,6")), Error);
    EXPECT_TRUE(request.asked.light_words.empty());
}

TEST(ViewRequest, SizesAreCutInProportion)
{
    ViewRequest request = default_request("grid", "kitchen");
    set_size(request, 1280.0, 720.0);
    EXPECT_EQ(request.asked.settings.width, 1280);
    EXPECT_EQ(request.asked.settings.height, 720);
    set_size(request, 1.0e300, 1.0e300);
    EXPECT_LE(request.asked.settings.width * request.asked.settings.height, most_pixels);
    EXPECT_EQ(request.asked.settings.width, request.asked.settings.height);
    set_size(request, 16384.0, 16.0);
    EXPECT_LE(request.asked.settings.width * request.asked.settings.height, most_pixels);
    set_size(request, std::nan(""), -5.0);
    EXPECT_EQ(request.asked.settings.width, 16);
    EXPECT_EQ(request.asked.settings.height, 16);
}

ViewRequest wish_of(std::vector<const char*> words)
{
    words.insert(words.begin(), {"lambent", "view"});
    const cli::Arguments parsed = cli::parse_arguments(static_cast<int>(words.size()), words.data());
    return starting_request(std::get<cli::ViewArguments>(parsed).start);
}

// What a viewer's command line says is what its first picture's command says.
TEST(ViewRequest, StartsWithWhatTheCommandLineSays)
{
    EXPECT_EQ(command_of(wish_of({"grid"}), "a.png"),
              "lambent render grid --size 1280x720 --camera 0,0 -o a.png");
    EXPECT_EQ(command_of(wish_of({"sphere",
                                  "--env",
                                  "studio",
                                  "--size",
                                  "640x360",
                                  "--camera",
                                  "10,-20,3",
                                  "--target",
                                  "1,2,3",
                                  "--exposure",
                                  "7000",
                                  "--tone",
                                  "aces",
                                  "--model",
                                  "phong",
                                  "--alpha",
                                  "0.1",
                                  "--env-rotation",
                                  "270",
                                  "--background",
                                  "blur:0.35",
                                  "--density",
                                  "2",
                                  "--backend",
                                  "cpu",
                                  "--light",
                                  "directional:0,45,1,2,3",
                                  "--dither"}),
                         "a.png"),
              "lambent render sphere --env studio --size 640x360 --camera 10,-20,3 --target 1,2,3 --exposure "
              "7000 --tone "
              "aces --env-rotation -90 --background blur:0.35 --model phong --alpha 0.1 --light "
              "directional:0,45,1,2,3 "
              "--density 2 --backend cpu --dither -o a.png");
    EXPECT_THROW(wish_of({"grid", "--samples", "60000"}), Error); // everybody else would wait
    EXPECT_THROW(wish_of({"grid", "--exposure", "-1"}), Error);
    EXPECT_THROW(wish_of({"grid", "-o", "a.png"}), Error);
    EXPECT_THROW(wish_of({"grid", "--stats", "json"}), Error);
}

// What is drawn for a request is what its command draws: nothing of it has more digits than the words.
TEST(ViewRequest, ArgumentsAreThoseThatItsCommandTakes)
{
    for (const char* scene : {"sphere", "walker.glb"})
        for (const char* model : {"ggx", "phong"})
            for (const char* ibl : {"sampled", "split-sum"}) {
                ViewRequest request = default_request(scene, "-sky.hdr");
                request.eye.orbit(12.3456789, -1.23456789);
                request.eye.dolly({}, 0.12345678);
                request.asked.animation = "-walk";
                request.asked.builtin.density = 0.3f;
                request.moment = 1.23456789;
                for (const auto& [name, word] : {std::pair("model", model),
                                                 {"ibl", ibl},
                                                 {"exposure", "1.23456789"},
                                                 {"fov", "33.3333333"},
                                                 {"env-rotation", "-123.456789"},
                                                 {"roughness", "0.123456789"},
                                                 {"kd", "0.123456789,1,0"},
                                                 {"background", "blur:0.123456789"}})
                    set_value(request.asked, name, word);
                set_lights(request, {"point:1,2,3.3333333333,4,5,6", "directional:1,2,3,4,5"});
                std::vector<std::string> words = words_of(request);
                words.insert(words.begin(), "lambent");
                words.insert(words.end(), {"-o", "a.png"});
                std::vector<const char*> pointers;
                pointers.reserve(words.size());
                for (const std::string& word : words)
                    pointers.push_back(word.c_str());
                const auto parsed = std::get<cli::RenderArguments>(
                    cli::parse_arguments(static_cast<int>(pointers.size()), pointers.data()));
                cli::RenderArguments drawn = arguments_of(request);
                drawn.output = "a.png";
                const auto said = [](const cli::RenderArguments& arguments) {
                    std::vector<std::string> line;
                    for (const cli::OptionWord& word : cli::words_of(arguments, cli::command::render))
                        cli::append(line, word);
                    return line;
                };
                EXPECT_EQ(said(drawn), said(parsed));
                EXPECT_EQ(drawn.settings.samples, parsed.settings.samples);
                EXPECT_EQ(drawn.settings.texel_transfer, parsed.settings.texel_transfer);
                EXPECT_EQ(drawn.display.unlit_by_power, parsed.display.unlit_by_power);
                EXPECT_EQ(drawn.light_places, parsed.light_places);
                EXPECT_EQ(drawn.settings.lights.at(1).direction, parsed.settings.lights.at(1).direction);
            }
}

// A camera at (3, 2, 1) that looks along -X, and a scene around the origin.
TEST(ViewRequest, LooksThroughACameraOfTheScene)
{
    scene::Scene scene;
    scene.meshes.resize(1);
    scene.meshes[0].positions = {{-1, -1, -1}, {1, 1, 1}, {1, -1, 1}};
    scene.meshes[0].triangles = {{0, 1, 2}};
    scene.instances.resize(1);
    scene::Camera camera;
    camera.name = "side";
    camera.transform = glm::mat4({0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {3, 2, 1, 1});
    camera.vertical_fov = 0.5f;
    scene.cameras = {camera};
    camera.name = "plan";
    camera.vertical_fov = 0.0f;
    camera.vertical_size = 4.0f;
    scene.cameras.push_back(camera);
    ViewRequest request;
    request.asked.scene = "model.glb";
    look_through(request, scene, "side");
    EXPECT_EQ(value_of(request.asked, "fov"), "28.6479"); // 0.5 radians
    EXPECT_EQ(request.eye.options(), (std::vector<std::string>{"--camera", "90,0,3", "--target", "0,2,1"}));
    set_value(request.asked, "fov", "90");
    look_through(request, scene, "plan"); // at the target 4 m are seen, as 2 m away through 90 degrees
    EXPECT_EQ(request.eye.options(), (std::vector<std::string>{"--camera", "90,0,2", "--target", "1,2,1"}));
    EXPECT_THROW(look_through(request, scene, "top"), Error);
    // A frame of aspect 2 in a square picture: twice as much is seen from bottom to top.
    scene.cameras[0].aspect = scene.cameras[1].aspect = 2.0f;
    request.asked.settings.width = request.asked.settings.height = 256;
    look_through(request, scene, "plan");
    EXPECT_EQ(request.eye.options(), (std::vector<std::string>{"--camera", "90,0,4", "--target", "-1,2,1"}));
    look_through(request, scene, "side");
    EXPECT_NEAR(std::stod(value_of(request.asked, "fov")),
                2.0 * std::atan(2.0 * std::tan(0.25)) * 180.0 / 3.14159265359, 1e-3);
    scene.origin = {4.5e6, 0.0, 0.0};
    look_through(request, scene, "side");
    EXPECT_EQ(request.eye.options(),
              (std::vector<std::string>{"--camera", "90,0,3", "--target", "4500000,2,1"}));
}

} // namespace
} // namespace lambent::viewer
