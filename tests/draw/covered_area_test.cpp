// The part of a picture in which a scene can be seen, against points projected by the camera's own axes.
#include "view/covered_area.h"
#include "tests/draw/test_scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lambent::view {
namespace {

constexpr int width = 320, height = 180;

// In pixels from the top left corner.
glm::dvec2 seen_at(const Camera& camera, const glm::vec3& point)
{
    const glm::dvec3 away(point - camera.position);
    double half = 0.5 * static_cast<double>(camera.vertical_size);
    if (camera.vertical_fov > 0.0f)
        half = -glm::dot(away, glm::dvec3(camera.back)) *
               std::tan(0.5 * static_cast<double>(camera.vertical_fov));
    return {0.5 * width + 0.5 * height * glm::dot(away, glm::dvec3(camera.right)) / half,
            0.5 * height - 0.5 * height * glm::dot(away, glm::dvec3(camera.up)) / half};
}

struct View {
    scene::Bounds bounds;
    Camera camera;
    PixelArea area;
};

// A box of any place and shape before a camera that may see all of it, a part or nothing.
View random_view(std::mt19937& random, bool orthographic)
{
    std::uniform_real_distribution<float> number(-1.0f, 1.0f);
    const auto point = [&] { return glm::vec3(number(random), number(random), number(random)); };
    View view;
    const glm::vec3 middle = 3.0f * point(), size = glm::abs(point());
    view.bounds = {middle - size, middle + size};
    scene::Bounds room{glm::vec3(-2.0f), glm::vec3(2.0f)};
    view.camera = orbit_camera(room, {3.0f * number(random), number(random), 9.0f}, 0.8f, 16.0f / 9.0f);
    if (orthographic) {
        view.camera.vertical_fov = 0.0f;
        view.camera.vertical_size = 4.0f;
    }
    view.area = covered_area(view.bounds, ray_map(view.camera, width, height), width, height);
    return view;
}

TEST(CoveredArea, HoldsWhatTheBoxCoversAndLittleElse)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    int cut = 0;
    for (int i = 0; i < 400; ++i) {
        const View view = random_view(random, i % 2 == 0);
        const PixelArea& area = view.area;
        ASSERT_GE(std::min(area.x, area.y), 0);
        ASSERT_GE(std::min(area.width, area.height), 1);
        ASSERT_LE(area.x + area.width, width);
        ASSERT_LE(area.y + area.height, height);
        glm::dvec2 low(1e9), high(-1e9);
        for (int n = 0; n < 64; ++n) {
            const auto at = [&](int axis, float random_share) {
                const float along = n < 8 ? static_cast<float>(n >> axis & 1) : random_share;
                return view.bounds.low[axis] + along * (view.bounds.high[axis] - view.bounds.low[axis]);
            };
            const glm::vec3 point(at(0, share(random)), at(1, share(random)), at(2, share(random)));
            const glm::dvec2 place = seen_at(view.camera, point);
            low = glm::min(low, place);
            high = glm::max(high, place);
            if (place.x < 0.0 || place.y < 0.0 || place.x >= width || place.y >= height)
                continue;
            EXPECT_TRUE(place.x >= area.x && place.x < area.x + area.width) << i;
            EXPECT_TRUE(place.y >= area.y && place.y < area.y + area.height) << i;
        }
        cut += area.width < width && area.height < height;
        EXPECT_LE(area.width, std::max(high.x - low.x, 0.0) + 5.0);
        EXPECT_LE(area.height, std::max(high.y - low.y, 0.0) + 5.0);
    }
    EXPECT_GT(cut, 200);
}

TEST(CoveredArea, IsTheWholePictureWhereTheBoxReachesBehindTheCamera)
{
    const scene::Bounds room{glm::vec3(-2.0f), glm::vec3(2.0f)};
    const RayMap rays = ray_map(orbit_camera(room, {0.3f, 0.2f, 1.0f}, 0.8f, 16.0f / 9.0f), width, height);
    const PixelArea area = covered_area(room, rays, width, height);
    EXPECT_EQ(area.width, width);
    EXPECT_EQ(area.height, height);
}

TEST(CoveredArea, OfNothingIsWithinThePicture)
{
    const scene::Bounds room{glm::vec3(-2.0f), glm::vec3(2.0f)};
    const RayMap rays = ray_map(orbit_camera(room, {0.3f, 0.2f, 9.0f}, 0.8f, 16.0f / 9.0f), width, height);
    const PixelArea area = covered_area({}, rays, width, height);
    EXPECT_GE(area.width, 1);
    EXPECT_LE(area.x + area.width, width);
}

} // namespace
} // namespace lambent::view
