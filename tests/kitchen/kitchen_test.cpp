// The kitchen as a place: whole, open where it has to be, and light enough.
#include "kitchen/model/kitchen.h"
#include "kitchen/model/plan.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent::kitchen {
namespace {

const scene::Scene& kitchen()
{
    static const scene::Scene scene = make_kitchen();
    return scene;
}

// Every mesh is placed once and as it is, so that its own numbers are the room's.
template <class Visit>
void for_each_triangle(Visit&& visit)
{
    for (const scene::Mesh& mesh : kitchen().meshes)
        for (const glm::uvec3 t : mesh.triangles)
            visit(glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
                  glm::dvec3(mesh.positions[t.z]), mesh);
}

glm::dvec3 towards_sun()
{
    const double azimuth = static_cast<double>(sun_azimuth), elevation = static_cast<double>(sun_elevation);
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            std::cos(elevation) * std::cos(azimuth)};
}

// Distance to the nearest triangle, seen from either side. [Moller and Trumbore 1997]
double nearest(const glm::dvec3& origin, const glm::dvec3& direction)
{
    double found = std::numeric_limits<double>::infinity();
    for_each_triangle([&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const scene::Mesh&) {
        const glm::dvec3 p = glm::cross(direction, c - a);
        const double volume = glm::dot(b - a, p);
        if (std::fabs(volume) < 1e-14)
            return;
        const double u = glm::dot(origin - a, p) / volume;
        const glm::dvec3 q = glm::cross(origin - a, b - a);
        const double v = glm::dot(direction, q) / volume, distance = glm::dot(c - a, q) / volume;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 1e-6)
            found = std::min(found, distance);
    });
    return found;
}

// [Ericson 2005, "Real-Time Collision Detection", 5.1.5], by projection and the three edges.
double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                            const glm::dvec3& c)
{
    const auto to_edge = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 edge = to - from;
        const double t = glm::clamp(glm::dot(p - from, edge) / glm::dot(edge, edge), 0.0, 1.0);
        return glm::length(p - from - t * edge);
    };
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return glm::dot(glm::cross(to - from, p - from), n) >= 0.0;
    };
    if (inside(a, b) && inside(b, c) && inside(c, a))
        return std::fabs(glm::dot(p - a, n));
    return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

TEST(Kitchen, EveryMeshIsWhole)
{
    const scene::Scene& scene = kitchen();
    ASSERT_EQ(scene.instances.size(), scene.meshes.size());
    for (const scene::Instance& instance : scene.instances)
        EXPECT_EQ(instance.transform, glm::mat4(1.0f));
    for (const scene::Mesh& mesh : scene.meshes) {
        const std::string& name = scene.materials.at(static_cast<std::size_t>(mesh.material)).name;
        const std::size_t count = mesh.positions.size();
        EXPECT_FALSE(mesh.triangles.empty()) << name;
        ASSERT_EQ(mesh.normals.size(), count) << name;
        ASSERT_EQ(mesh.texcoords[0].size(), count) << name;
        ASSERT_EQ(mesh.colors.size(), count) << name;
        for (std::size_t i = 0; i < count; ++i) {
            const glm::vec3 p = mesh.positions[i];
            const glm::vec2 uv = mesh.texcoords[0][i];
            ASSERT_TRUE(std::isfinite(p.x + p.y + p.z + uv.x + uv.y)) << name << " " << i;
            ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-4f) << name << " " << i;
        }
        for (const glm::uvec3 t : mesh.triangles)
            ASSERT_TRUE(t.x < count && t.y < count && t.z < count) << name;
    }
}

TEST(Kitchen, TrianglesHaveAreaAndFaceTheirNormals)
{
    int narrow = 0, turned = 0, all = 0;
    for (const scene::Mesh& mesh : kitchen().meshes)
        for (const glm::uvec3 t : mesh.triangles) {
            const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
            const glm::dvec3 face = glm::cross(b - a, c - a);
            const glm::dvec3 normal(mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]);
            ++all;
            narrow += glm::length(face) < 1e-10; // 5e-5 mm^2
            turned += glm::dot(face, normal) < 0.0;
        }
    EXPECT_LT(narrow, all / 1000);
    EXPECT_EQ(turned, 0);
}

TEST(Kitchen, StaysWithinItsTriangles)
{
    EXPECT_GT(scene::triangle_count(kitchen()), 100'000u);
    EXPECT_LT(scene::triangle_count(kitchen()), 400'000u);
}

TEST(Kitchen, ColoursArePlausible)
{
    const scene::Scene& scene = kitchen();
    for (const scene::Mesh& mesh : scene.meshes) {
        const scene::Material& m = scene.materials[static_cast<std::size_t>(mesh.material)];
        float brightest_texel = 1.0f;
        if (m.base_color_texture.image >= 0) {
            const image::CodeImage& image =
                scene.images[static_cast<std::size_t>(m.base_color_texture.image)];
            std::uint8_t brightest = 0;
            for (std::size_t i = 0; i < image.bytes.size(); ++i)
                brightest = i % 4 == 3 ? brightest : std::max(brightest, image.bytes[i]);
            brightest_texel = std::pow((static_cast<float>(brightest) / 255.0f + 0.055f) / 1.055f, 2.4f);
        }
        for (const glm::vec4& tint : mesh.colors)
            for (int c = 0; c < 3; ++c) {
                ASSERT_LE(brightest_texel * m.base_color[c] * tint[c], 0.9f) << m.name;
                ASSERT_GE(tint[c], 0.0f) << m.name;
            }
        // Lamps that no tracer finds by chance, and perfect mirrors, would be noise.
        EXPECT_LE(std::max({m.emissive.x, m.emissive.y, m.emissive.z}), 1.0f) << m.name;
        EXPECT_GE(m.perceptual_roughness, 0.15f) << m.name;
    }
}

TEST(Kitchen, TheEyeIsFree)
{
    const glm::dvec3 eye(kitchen_viewpoint());
    double least = std::numeric_limits<double>::infinity();
    for_each_triangle([&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const scene::Mesh&) {
        if (glm::length(glm::cross(b - a, c - a)) > 0.0)
            least = std::min(least, distance_to_triangle(eye, a, b, c));
    });
    EXPECT_GT(least, 0.3);
    EXPECT_LT(least, 1.5); // it is in the room
}

TEST(Kitchen, WindowsAreOpen)
{
    const glm::dvec3 eye(kitchen_viewpoint());
    const std::vector<glm::vec3> panes = plan::pane_middles();
    ASSERT_EQ(panes.size(), static_cast<std::size_t>(plan::window.panes + plan::patio_door.panes));
    for (const glm::vec3& pane : panes) {
        // Above one's eyes there is sky, below them the garden.
        const double way = nearest(eye, glm::normalize(glm::dvec3(pane) - eye));
        EXPECT_GT(way, pane.y > kitchen_viewpoint().y ? 1e9 : 8.0)
            << pane.x << " " << pane.y << " " << pane.z;
    }
}

TEST(Kitchen, IsClosedElsewhere)
{
    // From the eye in many directions: what escapes is the openings, which are known by their solid angle.
    const glm::dvec3 eye(kitchen_viewpoint());
    constexpr int count = 600;
    int escaped = 0;
    for (int i = 0; i < count; ++i) {
        // Evenly over the sphere, along a spiral. [Vogel 1979]
        const double y = 1.0 - 2.0 * (i + 0.5) / count, angle = 2.399963229728653 * i,
                     r = std::sqrt(1.0 - y * y);
        const glm::dvec3 direction(r * std::cos(angle), y, r * std::sin(angle));
        const double way = nearest(eye, direction);
        const glm::dvec3 end = eye + std::min(way, 1e6) * direction;
        if (end.x < static_cast<double>(plan::east + plan::wall) &&
            end.z < static_cast<double>(plan::south + plan::wall))
            continue;
        ++escaped;
        const double to_east = (static_cast<double>(plan::east) - eye.x) / direction.x;
        const double to_south = (static_cast<double>(plan::south) - eye.z) / direction.z;
        const glm::dvec3 at_east = eye + to_east * direction, at_south = eye + to_south * direction;
        const bool window = to_east > 0.0 && at_east.y > plan::window.low.y &&
                            at_east.y < plan::window.high.y && at_east.z > plan::window.low.x &&
                            at_east.z < plan::window.high.x;
        const bool door = to_south > 0.0 && at_south.y < plan::patio_door.high.y &&
                          -at_south.x > plan::patio_door.low.x && -at_south.x < plan::patio_door.high.x;
        EXPECT_TRUE(window || door) << direction.x << " " << direction.y << " " << direction.z;
    }
    EXPECT_GT(escaped, count / 40);
    EXPECT_LT(escaped, count / 5);
}

TEST(Kitchen, TheSunShinesOnTheIslandAndTheFloor)
{
    int on_island = 0, on_floor = 0;
    constexpr int steps = 12;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double s = (i + 0.5) / steps, t = (j + 0.5) / steps;
            const glm::dvec3 top(glm::mix(plan::island_low.x, plan::island_high.x, static_cast<float>(s)),
                                 plan::counter_top + 0.002f,
                                 glm::mix(plan::island_low.y, plan::island_high.y, static_cast<float>(t)));
            const glm::dvec3 floor(glm::mix(plan::west, plan::east, static_cast<float>(s)), 0.002,
                                   glm::mix(-0.9f, plan::south, static_cast<float>(t)));
            on_island += std::isinf(nearest(top, towards_sun()));
            on_floor += std::isinf(nearest(floor, towards_sun()));
        }
    EXPECT_GT(on_island, steps * steps / 20);
    EXPECT_GT(on_floor, steps * steps / 20);
}

TEST(Kitchen, IsTheSameEveryTime)
{
    const scene::Scene again = make_kitchen();
    ASSERT_EQ(again.meshes.size(), kitchen().meshes.size());
    for (std::size_t i = 0; i < again.meshes.size(); ++i) {
        EXPECT_EQ(again.meshes[i].positions, kitchen().meshes[i].positions);
        EXPECT_EQ(again.meshes[i].texcoords[0], kitchen().meshes[i].texcoords[0]);
        EXPECT_EQ(again.meshes[i].colors, kitchen().meshes[i].colors);
        EXPECT_EQ(again.meshes[i].triangles, kitchen().meshes[i].triangles);
    }
    for (std::size_t i = 0; i < again.images.size(); ++i)
        EXPECT_EQ(again.images[i].bytes, kitchen().images[i].bytes);
}

} // namespace
} // namespace lambent::kitchen
