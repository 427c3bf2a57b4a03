// Points and lines in pictures: no gaps, no more and no less than a pixel wide, lit or not, in front and behind.
#include "draw/line_renderer.h"
#include "tests/draw/line_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw::testing {
namespace {

Frame drawn(const scene::Scene& scene, const environment::Environment* environment, const Settings& settings)
{
    return with_lines(make_cpu_renderer(scene), scene)->draw(environment, settings);
}

std::vector<glm::ivec2> covered_pixels(const Frame& frame)
{
    std::vector<glm::ivec2> pixels;
    for (int y = 0; y < frame.radiance.height; ++y)
        for (int x = 0; x < frame.radiance.width; ++x)
            if (pixel(frame, x, y).a > 0.0f)
                pixels.emplace_back(x, y);
    return pixels;
}

// How many pixels can be walked to from the first, in steps to one of eight neighbours.
std::size_t reached(std::vector<glm::ivec2> pixels)
{
    std::vector<glm::ivec2> front = {pixels.back()};
    pixels.pop_back();
    std::size_t count = 1;
    while (!front.empty()) {
        const glm::ivec2 here = front.back();
        front.pop_back();
        for (std::size_t i = pixels.size(); i-- > 0;)
            if (std::abs(pixels[i].x - here.x) <= 1 && std::abs(pixels[i].y - here.y) <= 1) {
                front.push_back(pixels[i]);
                pixels.erase(pixels.begin() + static_cast<std::ptrdiff_t>(i));
                ++count;
            }
    }
    return count;
}

// One look through the middle of each pixel, at every angle and every place within a pixel.
TEST(LinePicture, OneLookAPixelSeesNoGap)
{
    Settings settings = pixel_settings(80, 80);
    settings.edge_samples = 1;
    for (int i = 0; i < 60; ++i) {
        const float turn = 0.1047198f * static_cast<float>(i), shift = 0.173f * static_cast<float>(i % 7);
        const glm::vec3 way = 32.0f * glm::vec3(std::cos(turn), std::sin(turn), 0.0f),
                        middle(shift, 0.3f * shift, 0.0f);
        const Frame frame =
            drawn(scene_of(line(middle - way, middle + way), line_material({1, 0, 0})), nullptr, settings);
        const std::vector<glm::ivec2> pixels = covered_pixels(frame);
        const float steps = std::max(std::fabs(way.x), std::fabs(way.y));
        ASSERT_GE(static_cast<float>(pixels.size()), 2.0f * steps - 1.0f) << i;
        EXPECT_EQ(reached(pixels), pixels.size()) << i;
    }
}

// A line covers as many pixels as it is long, whatever its angle.
TEST(LinePicture, CoverageIsTheLength)
{
    Settings settings = pixel_settings(80, 80);
    settings.edge_samples = 16;
    for (int i = 0; i < 16; ++i) {
        const float turn = 0.05f + 0.2f * static_cast<float>(i);
        const glm::vec3 way = 35.0f * glm::vec3(std::cos(turn), std::sin(turn), 0.0f);
        const Frame frame =
            drawn(scene_of(line(-way, way), line_material({0.5, 0.25, 1})), nullptr, settings);
        EXPECT_NEAR(covered(frame.radiance), 70.0, 0.02 * 70.0) << i;
        for (const glm::ivec2& at : covered_pixels(frame)) {
            const glm::vec4 c = pixel(frame, at.x, at.y);
            EXPECT_NEAR(c.r, 0.5f * c.a, 1e-5f);
            EXPECT_NEAR(c.b, c.a, 1e-5f);
        }
    }
}

// Lines along the picture's very border, half outside: the half that is inside is seen.
TEST(LinePicture, LinesOnTheBorderAreHalfSeen)
{
    scene::Mesh frame;
    frame.positions = {{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}};
    frame.lines = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    const Frame picture = drawn(scene_of(frame, line_material({1, 0, 0})), nullptr, pixel_settings(40, 40));
    for (int i = 1; i < 39; ++i)
        for (const glm::ivec2& at : {glm::ivec2(i, 0), {i, 39}, {0, i}, {39, i}})
            EXPECT_NEAR(pixel(picture, at.x, at.y).a, 0.5f, 0.01f) << at.x << " " << at.y;
    EXPECT_EQ(pixel(picture, 2, 2).a, 0.0f);
}

TEST(LinePicture, PointsCoverAPixelEach)
{
    Settings settings = pixel_settings(40, 40);
    settings.edge_samples = 64;
    const scene::Mesh mesh = points({{-10.5f, 4.5f, 0}, {3.0f, 3.0f, 0}, {7.3f, -8.2f, 0}});
    const Frame frame = drawn(scene_of(mesh, line_material({0, 1, 0})), nullptr, settings);
    EXPECT_NEAR(pixel(frame, 9, 15).g, 1.0f, 1e-5f);
    for (const glm::ivec2& at : {glm::ivec2(22, 16), {23, 16}, {22, 17}, {23, 17}})
        EXPECT_NEAR(pixel(frame, at.x, at.y).a, 0.25f, 0.02f);
    EXPECT_NEAR(covered(frame.radiance), 3.0, 0.1);
    settings.edge_samples = 1;
    EXPECT_GE(covered_pixels(drawn(scene_of(mesh, line_material({0, 1, 0})), nullptr, settings)).size(), 3u);
}

// From red to blue; unlit, so that no light changes it.
TEST(LinePicture, ColoursGoFromEndToEnd)
{
    scene::Mesh mesh = line({-20, 0.5f, 0}, {20, 0.5f, 0});
    mesh.colors = {{1, 0, 0, 1}, {0, 0, 1, 1}};
    const environment::Environment white = white_environment();
    const Frame frame = drawn(scene_of(mesh, line_material({1, 1, 1})), &white, pixel_settings(40, 10));
    for (int x = 0; x < 40; ++x) {
        const float part = (static_cast<float>(x) + 0.5f) / 40.0f;
        EXPECT_NEAR(pixel(frame, x, 4).r, 1.0f - part, 1e-3f);
        EXPECT_NEAR(pixel(frame, x, 4).b, part, 1e-3f);
    }
}

// With normals a line is lit as a surface with that normal is, from both sides.
TEST(LinePicture, WithNormalsLinesAreLitAsSurfaces)
{
    const environment::Environment sky =
        environment_of(64, [](glm::dvec3 d) { return glm::vec3(d.y > 0.0 ? 1.0f : 0.1f); });
    const glm::vec3 normal = glm::normalize(glm::vec3(0.0f, 1.0f, 1.0f));
    scene::Material gray;
    gray.base_color = {0.5f, 0.5f, 0.5f, 1.0f};
    gray.metallic = 0.0f;
    gray.double_sided = true;
    scene::Mesh square = facing_square(10.0f, 0.0f);
    square.normals.assign(4, normal);
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = -normal;
    for (const float side : {1.0f, -1.0f}) {
        scene::Mesh mesh = line({-10, 0.5f, 0}, {10, 0.5f, 0});
        mesh.normals.assign(2, side * normal);
        scene::Scene lines = scene_of(mesh, gray), surface = scene_of(square, gray);
        lines.lights = surface.lights = {sun};
        const glm::vec4 found = pixel(drawn(lines, &sky, pixel_settings(20, 20)), 9, 9),
                        wanted = pixel(draw(surface, &sky, pixel_settings(20, 20)), 9, 9);
        EXPECT_GT(wanted.r, 0.2f);
        EXPECT_NEAR(found.a, 1.0f, 1e-5f);
        EXPECT_NEAR(found.r, wanted.r, 0.01f * wanted.r) << side;
    }
}

TEST(LinePicture, SurfacesHideWhatIsBehindThem)
{
    scene::Scene scene = scene_of(line({-10, 0.5f, -1}, {10, 0.5f, -1}), line_material({1, 0, 0}));
    add(scene, line({-10, -4.5f, 1}, {10, -4.5f, 1}), line_material({0, 1, 0}));
    add(scene, facing_square(6.0f, 0.0f), glowing({0, 0, 1}));
    const Frame frame = drawn(scene, nullptr, pixel_settings(20, 20));
    EXPECT_EQ(pixel(frame, 9, 9), glm::vec4(0, 0, 1, 1));
    EXPECT_NEAR(pixel(frame, 1, 9).r, 1.0f, 1e-5f);
    EXPECT_NEAR(pixel(frame, 9, 14).g, 1.0f, 1e-5f);
}

// Pictures from several cameras in turns, and of several moments: each as by a renderer of its own.
TEST(LinePicture, EachPictureHasItsOwnLines)
{
    scene::Scene scene = scene_of(line({-1, -1, -1}, {1, 1, 1}), line_material({1, 0, 0}));
    add(scene, facing_square(0.5f, 0.0f), glowing({0, 0, 1}));
    scene::Scene later = scene;
    later.instances[0].transform[3].x = 0.7f;
    Settings first = small_settings(150, 100, odd_camera()), second = first;
    second.camera = front_camera(3.0f);
    const auto renderer = with_lines(make_cpu_renderer(scene), scene);
    const std::unique_ptr<Drawing> paused = renderer->start(nullptr, first);
    EXPECT_FALSE(paused->advance([](float) { return false; }));
    EXPECT_EQ(renderer->draw(nullptr, second).radiance.values, drawn(scene, nullptr, second).radiance.values);
    EXPECT_TRUE(paused->advance({}));
    const Frame whole = paused->take();
    EXPECT_EQ(whole.radiance.values, drawn(scene, nullptr, first).radiance.values);
    renderer->pose(later);
    EXPECT_EQ(renderer->draw(nullptr, first).radiance.values, drawn(later, nullptr, first).radiance.values);
    EXPECT_NE(renderer->draw(nullptr, first).radiance.values, whole.radiance.values);
}

// Those of scenes without lines are handed through.
TEST(LinePicture, OtherScenesPayNothing)
{
    const scene::Scene scene = scene_of(facing_square(1.0f, 0.0f), {});
    std::unique_ptr<Renderer> renderer = make_cpu_renderer(scene);
    const Renderer* const before = renderer.get();
    EXPECT_EQ(with_lines(std::move(renderer), scene).get(), before);
}

} // namespace
} // namespace lambent::draw::testing
