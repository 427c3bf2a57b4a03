// Cube maps unrolled.
#include "image/cube/cube_panorama.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lambent::image {
namespace {

// Each texel its own direction, plus 2 for no value to be negative; by the table in cube_map.h.
CubeMap directions(int size)
{
    CubeMap map = make_cube_map(size, full_levels(size));
    for (int level = 0; level < map.levels; ++level)
        for (int face = 0; face < 6; ++face) {
            const int n = map.face_size(level);
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    const double s = (2.0 * x + 1.0) / n - 1.0, t = (2.0 * y + 1.0) / n - 1.0;
                    const double all[6][3] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t},
                                              {s, -1, -t}, {s, -t, 1},  {-s, -t, -1}};
                    const double length = std::sqrt(1.0 + s * s + t * t);
                    for (int c = 0; c < 3; ++c)
                        map.pixel(level, face, x, y)[c] = static_cast<float>(2.0 + all[face][c] / length);
                }
        }
    return map;
}

TEST(CubePanorama, looks_each_direction_up)
{
    const CubeMap map = directions(64);
    for (const int level : {0, 1, 2}) {
        const int height = 50;
        const RadianceImage image = equirectangular_image(map, level, height);
        ASSERT_EQ(image.width, 100);
        ASSERT_EQ(image.height, height);
        // What a chord is off its arc, and more at edges, where the planes bend.
        const double step = 2.0 / map.face_size(level), tolerance = 2.5 * step * step;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < 2 * height; ++x) {
                const double longitude = (2.0 * x + 1.0 - 2 * height) / (2 * height) * std::numbers::pi;
                const double latitude = (height - 2.0 * y - 1.0) / (2 * height) * std::numbers::pi;
                const double d[3] = {std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                                     std::cos(latitude) * std::sin(longitude)};
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(image.pixel(x, y)[c], 2.0 + d[c], tolerance) << level << ' ' << x << ' ' << y;
            }
    }
}

TEST(CubePanorama, one_texel_a_face_is_enough)
{
    CubeMap map = make_cube_map(1, 1);
    for (std::size_t i = 0; i < map.values.size(); ++i)
        map.values[i] = 3.0f;
    for (const float value : equirectangular_image(map, 0, 1).values)
        EXPECT_NEAR(value, 3.0, 1e-6);
    for (const float value : equirectangular_image(map, 0, 7).values)
        EXPECT_NEAR(value, 3.0, 1e-6);
}

TEST(CubePanorama, refuses_what_is_none)
{
    const CubeMap map = make_cube_map(2, 1);
    EXPECT_THROW(equirectangular_image(map, 0, 0), Error);
    EXPECT_THROW(equirectangular_image(map, 0, 32769), Error);
    EXPECT_THROW(equirectangular_image(map, 1, 4), Error);
    EXPECT_THROW(equirectangular_image(map, -1, 4), Error);
    EXPECT_THROW(equirectangular_image(CubeMap{}, 0, 4), Error);
}

} // namespace
} // namespace lambent::image
