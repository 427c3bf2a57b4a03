// What the page's figures are made of.
#include "apps/report/oval.h"
#include "apps/report/shot.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace lambent::report {
namespace {

TEST(Shot, CommandsAreQuotedForAShell)
{
    EXPECT_EQ(typed({"lambent", "render", "a b.glb", "it's", "", "x;y", "-o", "a-1.png"}),
              "lambent render 'a b.glb' 'it'\\''s' '' 'x;y' -o a-1.png");
}

TEST(Shot, WordsAreLeftOutWithTheirValues)
{
    const Words words = {"sphere",  "--exposure", "7",      "--dither", "--samples",   "5",
                         "--space", "nonlinear",  "--tone", "agx",      "--mip-level", "report"};
    EXPECT_EQ(without_display(words),
              (Words{"sphere", "--samples", "5", "--space", "nonlinear", "--mip-level", "report"}));
    EXPECT_EQ(without_approximations(words),
              (Words{"sphere", "--exposure", "7", "--dither", "--space", "nonlinear", "--tone", "agx"}));
}

// Exposure comes before the light there, not after it.
TEST(Shot, OfTheReportsPipelineNoWordIsLeftOut)
{
    const Words words = {"sphere", "--pipeline", "report", "--exposure", "7"};
    EXPECT_EQ(without_display(words), words);
}

TEST(Shot, WordsAreWhatTheCommandLineTakes)
{
    const cli::RenderArguments arguments = parse_render({"sphere", "--model", "phong", "--alpha", "20"});
    EXPECT_EQ(arguments.scene, "sphere");
    EXPECT_EQ(arguments.builtin.exponent, 20.0f);
    EXPECT_EQ(parse_reference({"sphere", "--spp", "4"}).samples, 4);
    EXPECT_THROW(parse_render({"sphere", "--spp", "4"}), Error);
}

TEST(Shot, NumbersAreRounded)
{
    EXPECT_EQ(rounded(4.2345), "4.23");
    EXPECT_EQ(rounded(1234.6), "1235");
    EXPECT_EQ(rounded(0.001234), "0.00123");
    EXPECT_EQ(rounded(0.0), "0");
    EXPECT_EQ(rounded(1e-9), "1e-09");
    EXPECT_EQ(rounded(std::nan("")), "-");
    EXPECT_EQ(percent(0.0123), "1.2 %");
    EXPECT_EQ(percent(0.123), "12.3 %");
    EXPECT_EQ(percent(1.0), "100 %");
}

// A camera straight above the plane, at a height, as wide as it is high.
view::Camera above(float height)
{
    view::Camera camera;
    camera.position = {0.0f, height, 0.0f};
    camera.right = {1.0f, 0.0f, 0.0f};
    camera.up = {0.0f, 0.0f, -1.0f};
    camera.back = {0.0f, 1.0f, 0.0f};
    camera.vertical_fov = 0.6f;
    return camera;
}

// Light where inside(x, z) on the plane y = 0, as a camera sees it.
template <class Inside>
image::RadianceImage spot(const view::Camera& camera, const Inside& inside)
{
    constexpr int width = 320, height = 180;
    image::RadianceImage light{width, height, 4, std::vector<float>(std::size_t{width} * height * 4)};
    const view::RayMap rays = view::ray_map(camera, width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float u = static_cast<float>(x) + 0.5f, v = static_cast<float>(y) + 0.5f;
            const glm::vec3 o = rays.origin + u * rays.origin_dx + v * rays.origin_dy,
                            d = rays.direction + u * rays.direction_dx + v * rays.direction_dy;
            const float t = -o.y / d.y;
            if (t > 0.0f && inside(o.x + t * d.x, o.z + t * d.z))
                for (int c = 0; c < 3; ++c)
                    light.pixel(x, y)[c] = 1.0f;
        }
    return light;
}

TEST(Oval, AnEllipseHasItsAspectOnTheGroundFromAnywhere)
{
    const auto ellipse = [](float x, float z) {
        return x * x / 0.01f + z * z / 0.09f < 1.0f;
    }; // 0.1 by 0.3 metres
    const Oval straight = highlight_shape(spot(above(2.0f), ellipse), above(2.0f));
    EXPECT_NEAR(straight.on_ground, 3.0, 0.05);
    EXPECT_NEAR(straight.in_picture, 3.0, 0.05);

    // From the front at 30 degrees: foreshortened to half in the picture, the same on the ground.
    const scene::Bounds bounds{glm::vec3(-1, 0, -1), glm::vec3(1, 0, 1)};
    const view::Camera slanted = view::orbit_camera(bounds, {0.0f, 0.5235988f, 3.0f}, 0.6f, 16.0f / 9.0f);
    const Oval seen = highlight_shape(spot(slanted, ellipse), slanted);
    EXPECT_NEAR(seen.on_ground, 3.0, 0.1);
    EXPECT_NEAR(seen.in_picture, 1.5, 0.1);
}

TEST(Oval, ACircleIsRoundAndDarknessHasNoShape)
{
    const auto circle = [](float x, float z) { return x * x + z * z < 0.04f; };
    EXPECT_NEAR(highlight_shape(spot(above(2.0f), circle), above(2.0f)).on_ground, 1.0, 0.02);
    const auto nothing = [](float, float) { return false; };
    EXPECT_EQ(highlight_shape(spot(above(2.0f), nothing), above(2.0f)).on_ground, 0.0);
}

} // namespace
} // namespace lambent::report
