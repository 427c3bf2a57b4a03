// Points and lines in the reference: as wide as in the renderer, and seen by the camera alone.
#include "tests/reference/traced.h"

#include <cmath>

namespace lambent::reference {
namespace {

using namespace testing;

scene::Mesh line(const glm::vec3& from, const glm::vec3& to)
{
    scene::Mesh mesh;
    mesh.positions = {from, to};
    mesh.lines = {{0, 1}};
    return mesh;
}

scene::Material line_material(const glm::vec3& color)
{
    scene::Material material = unlit(color);
    material.double_sided = true;
    return material;
}

double sum(const Result& result, std::size_t channel)
{
    double sum = 0.0;
    for (std::size_t i = channel; i < result.radiance.values.size(); i += 4)
        sum += static_cast<double>(result.radiance.values[i]);
    return sum;
}

// A metre is a pixel.
TEST(ReferenceLines, CoverAsManyPixelsAsTheyAreLong)
{
    const image::RadianceImage white = white_panorama();
    for (const float turn : {0.1f, 0.7853982f, 1.3f}) {
        const glm::vec3 way = 18.0f * glm::vec3(std::cos(turn), std::sin(turn), 0.0f);
        const Result result = trace(scene_of(line(-way, way), line_material({0.25f, 0.5f, 1.0f})), &white,
                                    small_settings(40, 40.0f, 64));
        EXPECT_NEAR(sum(result, 3), 36.0, 0.02 * 36.0);
        EXPECT_NEAR(sum(result, 0), 0.25 * sum(result, 3), 1e-3);
        EXPECT_NEAR(sum(result, 2), sum(result, 3), 1e-3);
    }
    scene::Mesh points;
    points.positions = {{0.5f, 0.5f, 0.0f}, {3.2f, 7.7f, 0.0f}};
    points.points = {0, 1};
    const Result result =
        trace(scene_of(points, line_material(glm::vec3(1.0f))), &white, small_settings(40, 40.0f, 256));
    EXPECT_NEAR(sum(result, 1), 2.0, 0.06);
    EXPECT_NEAR(static_cast<double>(result.radiance.pixel(20, 19)[3]), 1.0, 1e-6);
}

// Every fourth row of pixels is a line, a metre above a square, and its shadow would be two rows below. There the picture is
// what it is without lines, path by path.
TEST(ReferenceLines, AreSeenByTheCameraAlone)
{
    const image::RadianceImage white = white_panorama();
    scene::Scene bare = scene_of(facing_square(12.0f, 0.0f), metallic(0.8f, 0.0f, 0.3f));
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = glm::normalize(glm::vec3(0.0f, -2.0f, -1.0f));
    bare.lights = {sun};
    scene::Scene lines = bare;
    for (const float y : {-8.0f, -4.0f, 0.0f, 4.0f, 8.0f})
        add(lines, line({-9.0f, y, 1.0f}, {9.0f, y, 1.0f}), line_material({1, 0, 0}));
    Settings settings = small_settings(16, 16.0f, 16);
    settings.bounces = 4;
    settings.camera.position.y = 0.5f; // the middles of rows are at whole metres
    const Result with = trace(lines, &white, settings), without = trace(bare, &white, settings);
    for (int x = 0; x < 16; ++x)
        for (const int line_row : {0, 4, 8, 12}) {
            EXPECT_EQ(with.radiance.pixel(x, line_row)[1], 0.0f) << x;
            const float shaded = with.radiance.pixel(x, line_row + 2)[1];
            EXPECT_GT(shaded, 0.8f);
            EXPECT_EQ(shaded, without.radiance.pixel(x, line_row + 2)[1]) << x;
        }
}

// With normals they reflect what a square with those normals reflects, their own plane being in nobody's way.
TEST(ReferenceLines, WithNormalsAreLitAsSurfaces)
{
    const image::RadianceImage sky =
        panorama_of(16, [](const glm::dvec3& d) { return glm::dvec3(d.y > 0.0 ? 1.0 : 0.0); });
    scene::Mesh mesh = line({-10.0f, 0.5f, 0.0f}, {10.0f, 0.5f, 0.0f});
    mesh.normals.assign(2, {0.0f, 1.0f, 0.0f});
    scene::Material gray = phong(glm::vec3(0.5f), glm::vec3(0.0f), 1.0f);
    gray.double_sided = true;
    Settings settings = small_settings(2, 2.0f, 4096);
    settings.model = view::Model::phong;
    settings.camera.position = {0.0f, 6.0f, 8.0f}; // looks down by a little, so that the normal is seen
    settings.camera.back = glm::normalize(glm::vec3(0.0f, 0.6f, 0.8f));
    settings.camera.up = glm::cross(settings.camera.back, settings.camera.right);
    for (const int bounces : {0, 2}) {
        settings.bounces = bounces;
        const Result result = trace(scene_of(mesh, gray), &sky, settings);
        // Under a half sphere of light a surface that looks up shows its colour.
        const double coverage = sum(result, 3);
        EXPECT_GT(coverage, 1.0);
        EXPECT_NEAR(sum(result, 1) / coverage, 0.5, 0.01) << bounces;
    }
}

TEST(ReferenceLines, PanoramasAreWithoutThem)
{
    Settings settings = small_settings(8, 8.0f, 1);
    settings.panorama_from = glm::vec3(0.0f);
    const Result result =
        trace(scene_of(line({-9, 0, -1}, {9, 0, -1}), line_material({1, 0, 0})), nullptr, settings);
    EXPECT_EQ(sum(result, 3), 0.0);
}

} // namespace
} // namespace lambent::reference
