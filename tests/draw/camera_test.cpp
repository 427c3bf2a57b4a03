// Cameras: which way they look, and what that puts where in the picture.
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace lambent::draw {
namespace {

using std::numbers::pi;
using testing::pixel;

void expect_near(glm::vec3 a, glm::vec3 b)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], 1e-5f) << "component " << i;
}

TEST(Camera, FramedScenesFit)
{
    scene::Bounds bounds;
    bounds.low = {-3.0f, 0.0f, -1.0f};
    bounds.high = {1.0f, 2.0f, 5.0f};
    for (float aspect : {0.4f, 1.0f, 2.5f})
        for (float azimuth : {0.0f, 1.0f, 4.0f})
            for (float elevation : {-1.5f, 0.0f, 0.7f}) {
                const Camera camera = orbit_camera(bounds, {azimuth, elevation, 0.0f}, 0.8f, aspect);
                float most = 0.0f;
                for (int corner = 0; corner < 8; ++corner) {
                    const glm::vec3 p(corner & 1 ? bounds.low.x : bounds.high.x,
                                      corner & 2 ? bounds.low.y : bounds.high.y,
                                      corner & 4 ? bounds.low.z : bounds.high.z);
                    const glm::vec3 d = p - camera.position;
                    const float depth = -glm::dot(d, camera.back);
                    ASSERT_GT(depth, 0.0f);
                    const float up = std::tan(0.4f);
                    most = std::max({most, std::fabs(glm::dot(d, camera.up)) / depth / up,
                                     std::fabs(glm::dot(d, camera.right)) / depth / (up * aspect)});
                }
                EXPECT_LT(most, 1.0f);
                EXPECT_GT(most, 0.75f);
            }
}

TEST(Camera, OrbitFollowsItsConvention)
{
    scene::Bounds bounds;
    bounds.low = glm::vec3(-1.0f);
    bounds.high = glm::vec3(1.0f);
    EXPECT_NEAR(orbit_camera(bounds, {0.0f, 0.0f, 5.0f}, 0.8f, 1.0f).position.z, 5.0f, 1e-5f);
    EXPECT_NEAR(orbit_camera(bounds, {1.5707963f, 0.0f, 5.0f}, 0.8f, 1.0f).position.x, 5.0f, 1e-5f);
    EXPECT_NEAR(orbit_camera(bounds, {0.3f, 1.5707963f, 5.0f}, 0.8f, 1.0f).position.y, 5.0f, 1e-5f);
}

// Nothing is upside down or mirrored, and the middle of the bounds is in the middle of the picture.
TEST(Camera, OrbitLooksAtTheMiddleUpright)
{
    scene::Bounds bounds;
    bounds.low = {-3.0f, 0.0f, -1.0f};
    bounds.high = {1.0f, 2.0f, 5.0f};
    const glm::vec3 centre(-1.0f, 1.0f, 2.0f);
    for (const float azimuth : {-2.0f, 0.0f, 1.0f, 4.0f})
        for (const float elevation : {-1.5f, -0.7f, 0.0f, 0.7f, 1.5f})
            for (const float distance : {0.0f, 9.0f}) {
                const Camera camera = orbit_camera(bounds, {azimuth, elevation, distance}, 0.8f, 1.5f);
                SCOPED_TRACE(::testing::PrintToString(azimuth) + ' ' + ::testing::PrintToString(elevation));
                expect_near(camera.back, glm::normalize(camera.position - centre));
                expect_near(camera.right, glm::cross(camera.up, camera.back));
                EXPECT_NEAR(glm::length(camera.up), 1.0f, 1e-5f);
                EXPECT_NEAR(glm::dot(camera.up, camera.back), 0.0f, 1e-5f);
                EXPECT_NEAR(camera.right.y, 0.0f, 1e-5f);
                EXPECT_GT(camera.up.y, 0.0f);
            }
}

// Seen from +Z, +X is on the right; seen from +X, -Z is. Straight from above that is no different.
TEST(Camera, OrbitTurnsToTheRight)
{
    scene::Bounds bounds;
    bounds.low = glm::vec3(-1.0f);
    bounds.high = glm::vec3(1.0f);
    for (const float elevation : {-0.5f, 0.0f, 1.5707963f}) {
        expect_near(orbit_camera(bounds, {0.0f, elevation, 5.0f}, 0.8f, 1.0f).right, {1, 0, 0});
        expect_near(orbit_camera(bounds, {1.5707963f, elevation, 5.0f}, 0.8f, 1.0f).right, {0, 0, -1});
    }
    expect_near(orbit_camera(bounds, {0.0f, 1.5707963f, 5.0f}, 0.8f, 1.0f).up, {0, 0, -1});
    expect_near(orbit_camera(bounds, {0.0f, -1.5707963f, 5.0f}, 0.8f, 1.0f).up, {0, 0, 1});
}

// Two squares that face +X, one to the right and one above of where the camera looks: a quarter turn about +Y takes the
// way that cameras look, -Z, to -X, and their right, +X, to -Z.
scene::Scene two_squares(glm::vec3 ahead)
{
    const glm::mat4 facing_x = glm::rotate(glm::mat4(1.0f), static_cast<float>(0.5 * pi), glm::vec3(0, 1, 0));
    scene::Scene scene;
    testing::add(scene, testing::facing_square(0.15f, 0.0f), testing::glowing({1, 0, 0}),
                 glm::translate(glm::mat4(1.0f), ahead + glm::vec3(0, 0, -1)) * facing_x);
    testing::add(scene, testing::facing_square(0.15f, 0.0f), testing::glowing({0, 1, 0}),
                 glm::translate(glm::mat4(1.0f), ahead + glm::vec3(0, 1.5f, 0)) * facing_x);
    return scene;
}

// The middle of the light of a channel, in metres to the right and up from the middle of the picture, which shows
// `extent` metres from bottom to top.
glm::dvec2 middle_of_light(const Frame& frame, int channel, double extent)
{
    glm::dvec3 sum(0.0);
    const int width = frame.radiance.width, height = frame.radiance.height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sum += static_cast<double>(pixel(frame, x, y)[channel]) *
                   glm::dvec3(x + 0.5 - 0.5 * width, 0.5 * height - y - 0.5, 1.0);
    return glm::dvec2(sum) / sum.z * extent / static_cast<double>(height);
}

TEST(Camera, OfTheSceneSeesWhatIsInFrontOfIt)
{
    const glm::vec3 place(7.0f, 2.0f, -3.0f), ahead = place - glm::vec3(5, 0, 0);
    scene::Camera perspective, orthographic;
    perspective.transform = orthographic.transform =
        glm::rotate(glm::translate(glm::mat4(1.0f), place), static_cast<float>(0.5 * pi), glm::vec3(0, 1, 0));
    perspective.vertical_fov = 0.9f;
    orthographic.vertical_size = 5.0f;
    const scene::Scene scene = two_squares(ahead);
    for (const scene::Camera& camera : {perspective, orthographic}) {
        const double extent = camera.vertical_fov > 0.0f ? 2.0 * 5.0 * std::tan(0.45) : 5.0;
        const Frame frame =
            testing::draw(scene, nullptr, testing::small_settings(120, 80, from_scene(camera)));
        const glm::dvec2 red = middle_of_light(frame, 0, extent), green = middle_of_light(frame, 1, extent);
        EXPECT_NEAR(red.x, 1.0, 0.02);
        EXPECT_NEAR(red.y, 0.0, 0.02);
        EXPECT_NEAR(green.x, 0.0, 0.02);
        EXPECT_NEAR(green.y, 1.5, 0.02);
    }
}

// What a camera of aspect 2 sees, 4 by 2 metres, is in the picture whatever the picture's own aspect is.
TEST(Camera, ShowsAllOfItsFrameAndMore)
{
    Camera camera = testing::front_camera(2.0f);
    camera.aspect = 2.0f;
    Camera perspective = camera;
    perspective.vertical_fov = static_cast<float>(2.0 * std::atan(0.1)); // the same 10 m away
    const auto sides = [](const Camera& c, int width, int height) {
        const RayMap map = ray_map(c, width, height);
        const auto at = [&](float x, float y) {
            return map.origin + x * map.origin_dx + y * map.origin_dy +
                   10.0f * (map.direction + x * map.direction_dx + y * map.direction_dy);
        };
        const glm::vec3 corner = at(0.0f, 0.0f),
                        other = at(static_cast<float>(width), static_cast<float>(height));
        EXPECT_NEAR(corner.x, -other.x, 1e-5f);
        EXPECT_NEAR(corner.y, -other.y, 1e-5f);
        return glm::vec2(other.x, corner.y);
    };
    for (const Camera& c : {camera, perspective}) {
        const glm::vec2 same = sides(c, 128, 64), square = sides(c, 64, 64), tall = sides(c, 32, 64),
                        wide = sides(c, 256, 64);
        EXPECT_NEAR(same.x, 2.0f, 1e-5f);
        EXPECT_NEAR(same.y, 1.0f, 1e-5f);
        EXPECT_NEAR(square.x, 2.0f, 1e-5f);
        EXPECT_NEAR(square.y, 2.0f, 1e-5f);
        EXPECT_NEAR(tall.x, 2.0f, 1e-5f);
        EXPECT_NEAR(tall.y, 4.0f, 1e-5f);
        EXPECT_NEAR(wide.x, 4.0f, 1e-5f);
        EXPECT_NEAR(wide.y, 1.0f, 1e-5f);
    }
}

// Squares 10, 12 and 14 metres ahead: the nearest of those between the planes is seen.
TEST(Camera, SeesBetweenItsPlanes)
{
    scene::Scene scene;
    for (const int i : {0, 1, 2})
        testing::add(scene, testing::facing_square(9.0f, -2.0f * static_cast<float>(i)),
                     testing::glowing(glm::vec3(1.0f + static_cast<float>(i))));
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float fov : {0.0f, 0.9f})
        for (const auto& [near, far, seen] : {std::tuple(0.0f, infinite, 1.0f),
                                              {9.9f, 10.1f, 1.0f},
                                              {10.1f, infinite, 2.0f},
                                              {12.1f, 20.0f, 3.0f},
                                              {0.0f, 9.9f, 0.0f},
                                              {10.1f, 11.9f, 0.0f},
                                              {14.1f, infinite, 0.0f}}) {
            Camera camera = testing::front_camera(4.0f);
            camera.vertical_fov = fov;
            camera.near = near;
            camera.far = far;
            const Frame frame = testing::draw(scene, nullptr, testing::small_settings(9, 9, camera));
            for (const int x : {0, 4, 8})
                EXPECT_EQ(pixel(frame, x, 1).r, seen) << fov << ' ' << near << ' ' << far << ' ' << x;
        }
}

// Models of a tenth of a millimetre and of a hundred kilometres look like one of a metre.
TEST(Camera, ScenesOfAnySizeLookTheSame)
{
    const environment::Environment white = testing::white_environment();
    const auto drawn = [&](float size) {
        scene::Scene scene;
        const glm::mat4 scaled = glm::scale(glm::mat4(1.0f), glm::vec3(size));
        testing::add(scene, scene::make_sphere(1.0f, 48, 24), {}, scaled);
        testing::add(scene, testing::facing_square(2.0f, -1.0f), {}, scaled);
        scene::Light lamp;
        lamp.position = size * glm::vec3(2.0f, 2.0f, 3.0f);
        lamp.intensity = glm::vec3(5.0f * size * size);
        scene.lights = {lamp};
        Camera camera = testing::front_camera(0.0f, 5.0f * size);
        camera.vertical_fov = 0.8f;
        return testing::draw(scene, &white, testing::small_settings(64, 64, camera));
    };
    const Frame metre = drawn(1.0f);
    for (const float size : {0x1p-13f, 0x1p17f}) {
        const Frame other = drawn(size);
        double worst = 0.0;
        for (std::size_t i = 0; i < metre.radiance.values.size(); ++i)
            worst = std::max(worst, std::fabs(static_cast<double>(other.radiance.values[i]) -
                                              static_cast<double>(metre.radiance.values[i])));
        EXPECT_LT(worst, 1e-3) << size;
    }
}

} // namespace
} // namespace lambent::draw
