// Cube maps in memory: where texels lie, and what pictures of them look like.
#include "image/cube/cube_map.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lambent::image {
namespace {

using Direction = std::array<double, 3>;

// Every texel holds its direction, worked out from the two axes of each face as seen by OpenGL: face
// selection names the axis that is largest and what runs along s and t ["Cube Map Texture Selection"].
CubeMap directions(int size, int levels)
{
    // The face's axis, then that of s, then that of t, each as coordinate and sign.
    constexpr int axes[6][6] = {{0, 1, 2, -1, 1, -1}, {0, -1, 2, 1, 1, -1}, {1, 1, 0, 1, 2, 1},
                                {1, -1, 0, 1, 2, -1}, {2, 1, 0, 1, 1, -1},  {2, -1, 0, -1, 1, -1}};
    CubeMap map = make_cube_map(size, levels);
    for (int level = 0; level < levels; ++level)
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < map.face_size(level); ++y)
                for (int x = 0; x < map.face_size(level); ++x) {
                    const int* a = axes[face];
                    const auto n = static_cast<float>(map.face_size(level));
                    float* const out = map.pixel(level, face, x, y);
                    out[a[0]] = static_cast<float>(a[1]);
                    out[a[2]] = static_cast<float>(a[3]) * (static_cast<float>(2 * x + 1) / n - 1.0f);
                    out[a[4]] = static_cast<float>(a[5]) * (static_cast<float>(2 * y + 1) / n - 1.0f);
                }
    return map;
}

Direction direction(const float* texel)
{
    const double length = std::hypot(texel[0], texel[1], texel[2]);
    return {texel[0] / length, texel[1] / length, texel[2] / length};
}

double cosine(const Direction& a, const Direction& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void expect_usage(const std::string& reason, auto&& work)
{
    try {
        work();
        FAIL() << "not refused; wanted: " << reason;
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.failure()), static_cast<int>(Failure::usage));
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
}

TEST(CubeMap, has_levels_down_to_one_texel)
{
    EXPECT_EQ(full_levels(1), 1);
    EXPECT_EQ(full_levels(2), 2);
    EXPECT_EQ(full_levels(6), 3);
    EXPECT_EQ(full_levels(1024), 11);
    const CubeMap map = make_cube_map(6, 3);
    EXPECT_EQ(map.face_size(1), 3);
    EXPECT_EQ(map.face_size(2), 1);
    EXPECT_EQ(map.values.size(), 6u * 3u * (36u + 9u + 1u));
    EXPECT_EQ(map.level_start(1), 6u * 3u * 36u);
    EXPECT_EQ(map.pixel(1, 2, 1, 2) - map.values.data(), 6 * 3 * 36 + 2 * 27 + 3 * 7);
    EXPECT_EQ(map.face(1, 2).data(), map.pixel(1, 2, 0, 0));
    EXPECT_EQ(map.face(2, 5).data() + 3, map.values.data() + map.values.size());
}

TEST(CubeMap, refuses_what_is_none)
{
    for (int size : {0, -1, 65537})
        expect_usage("1 to 65536 texels", [&] { make_cube_map(size, 1); });
    expect_usage("1 to 3 levels", [] { make_cube_map(6, 4); });
    expect_usage("1 to 3 levels", [] { make_cube_map(6, 0); });
    CubeMap map = make_cube_map(2, 1);
    check_cube_map(map);
    map.values.pop_back();
    expect_usage("72 values, not 71", [&] { check_cube_map(map); });
    expect_usage("72 values, not 71", [&] { mirrored(map); });
}

TEST(CubeMap, mirrored_turns_x_round)
{
    const CubeMap map = directions(4, 3);
    const CubeMap mirror = mirrored(map);
    for (std::size_t i = 0; i < map.values.size(); i += 3) {
        ASSERT_EQ(mirror.values[i], -map.values[i]);
        ASSERT_EQ(mirror.values[i + 1], map.values[i + 1]);
        ASSERT_EQ(mirror.values[i + 2], map.values[i + 2]);
    }
    EXPECT_EQ(mirrored(mirror).values, map.values);
}

TEST(CubeMap, faces_become_pictures)
{
    const CubeMap map = directions(4, 3);
    const RadianceImage picture = face_image(map, 1, 3);
    EXPECT_EQ(picture.width, 2);
    EXPECT_EQ(picture.height, 2);
    EXPECT_EQ(picture.channels, 3);
    EXPECT_EQ(picture.values.size(), 12u);
    EXPECT_EQ(picture.pixel(1, 0)[0], 0.5f);
    EXPECT_EQ(picture.pixel(1, 0)[1], -1.0f);
    EXPECT_EQ(picture.pixel(1, 0)[2], 0.5f);
}

// Paper that folds to a cube: neighbours in the picture are neighbours on the sphere.
TEST(CubeMap, the_cross_has_no_seams)
{
    const RadianceImage cross = cross_image(directions(8, 2), 0);
    ASSERT_EQ(cross.width, 32);
    ASSERT_EQ(cross.height, 24);
    const auto lit = [&](int x, int y) { return y / 8 == 1 || x / 8 == 1; };
    int pairs = 0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 32; ++x) {
            const float* const p = cross.pixel(x, y);
            if (!lit(x, y)) {
                EXPECT_TRUE(p[0] == 0.0f && p[1] == 0.0f && p[2] == 0.0f);
                continue;
            }
            if (x + 1 < 32 && lit(x + 1, y)) {
                ++pairs;
                EXPECT_GT(cosine(direction(p), direction(cross.pixel(x + 1, y))), 0.96);
            }
            if (y + 1 < 24 && lit(x, y + 1)) {
                ++pairs;
                EXPECT_GT(cosine(direction(p), direction(cross.pixel(x, y + 1))), 0.96);
            }
        }
    EXPECT_EQ(pairs, 8 * (31 + 2 * 7) + 8 * 23 + 3 * 8 * 7);
    // +Z in the middle left, +X to its right, +Y above.
    EXPECT_GT(direction(cross.pixel(12, 12))[2], 0.9);
    EXPECT_GT(direction(cross.pixel(20, 12))[0], 0.9);
    EXPECT_GT(direction(cross.pixel(12, 4))[1], 0.9);
}

} // namespace
} // namespace lambent::image
