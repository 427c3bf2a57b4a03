// The projection against the rays that it stands for, put together the other way round.
#include "draw/vulkan/raster_map.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace lambent::draw {
namespace {

using glm::dvec3, glm::dvec4;

const scene::Bounds box = {{-3.0f, -2.0f, -4.0f}, {3.0f, 2.0f, 4.0f}};

Camera camera(float vertical_fov)
{
    Camera c;
    c.position = {1.0f, 2.0f, 9.0f};
    c.right = glm::normalize(glm::vec3(0.9f, 0.1f, -0.3f));
    c.back = glm::normalize(glm::cross(c.right, {0.0f, 1.0f, 0.1f}));
    c.up = glm::cross(c.back, c.right);
    c.vertical_fov = vertical_fov;
    c.vertical_size = 5.0f;
    return c;
}

dvec4 clip(const gpu_layout::RasterConstants& map, const dvec3& from_origin)
{
    const dvec4 p(from_origin, 1.0);
    return {glm::dot(dvec4(map.row_x), p), glm::dot(dvec4(map.row_y), p), glm::dot(dvec4(map.row_z), p),
            glm::dot(dvec4(map.row_w), p)};
}

// Every pixel of the window finds its place at its middle, nearer points before further ones.
void expect_places(const RayMap& rays)
{
    const RasterWindow window = {40, 7, 50, 30, {0.3f, 0.9f}};
    const auto map = raster_map(rays, window, box);
    ASSERT_TRUE(map);
    for (const auto& [i, j] : {std::pair(0, 0), {49, 29}, {20, 3}}) {
        const double x = 40.0 + i + 0.3, y = 7.0 + j + 0.9;
        double before = 1.0;
        for (const double t : {3.0, 8.0, 11.0}) {
            const dvec3 start = x * dvec3(rays.origin_dx) + y * dvec3(rays.origin_dy);
            const dvec3 direction =
                dvec3(rays.direction) + x * dvec3(rays.direction_dx) + y * dvec3(rays.direction_dy);
            const dvec4 p = clip(*map, start + t * direction);
            EXPECT_NEAR((p.x / p.w + 1.0) * 25.0, i + 0.5, 1e-3);
            EXPECT_NEAR((p.y / p.w + 1.0) * 15.0, j + 0.5, 1e-3);
            const double depth = p.z / p.w;
            EXPECT_GT(depth, 0.0);
            EXPECT_LT(depth, before);
            before = depth;
        }
    }
}

TEST(RasterMap, PutsPointsWhereTheirRaysAre)
{
    expect_places(ray_map(camera(0.7f), 320, 200));
    expect_places(ray_map(camera(0.0f), 320, 200));
}

// A device cuts off what has a depth below 0 or above 1.
TEST(RasterMap, CutsOffAtThePlanes)
{
    for (const float fov : {0.7f, 0.0f})
        for (const float last : {9.0f, 1000.0f}) {
            Camera limited = camera(fov);
            limited.near = 4.0f;
            limited.far = last;
            const RayMap rays = ray_map(limited, 320, 200);
            const auto map = raster_map(rays, {0, 0, 320, 200, {0.5f, 0.5f}}, box);
            ASSERT_TRUE(map);
            const auto depth = [&](double t) {
                const dvec3 start = 100.0 * dvec3(rays.origin_dx) + 80.0 * dvec3(rays.origin_dy);
                const dvec4 p =
                    clip(*map, start + t * (dvec3(rays.direction) + 100.0 * dvec3(rays.direction_dx) +
                                            80.0 * dvec3(rays.direction_dy)));
                return p.z / p.w;
            };
            EXPECT_GT(depth(3.999), 1.0);
            EXPECT_LT(depth(4.001), 1.0);
            EXPECT_GT(depth(8.99), 0.0);
            EXPECT_EQ(depth(9.01) < 0.0, last == 9.0f);
        }
}

TEST(RasterMap, ThereIsNoneOfWhatCannotBeSeen)
{
    RayMap flat = ray_map(camera(0.7f), 320, 200);
    flat.direction_dy = flat.direction_dx;
    EXPECT_FALSE(raster_map(flat, {}, box));
    const RayMap rays = ray_map(camera(0.7f), 320, 200);
    const scene::Bounds behind = {{0.0f, 0.0f, 50.0f}, {1.0f, 1.0f, 51.0f}};
    EXPECT_FALSE(raster_map(rays, {}, behind));
    EXPECT_FALSE(raster_map(rays, {}, scene::Bounds{}));
}

} // namespace
} // namespace lambent::draw
