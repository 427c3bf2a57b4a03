// What pictures with bounces get wrong first, against the path tracer or closed forms: contacts, thin walls, coarse meshes,
// mirrors before mirrors, white surfaces, very small and very large scenes.
#include "environment/builtin/builtin.h"
#include "tests/draw/light_pair.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <vector>

namespace lambent::draw::testing {
namespace {

scene::Material surface(float color, float metallic, float roughness)
{
    scene::Material material;
    material.base_color = {color, color, color, 1.0f};
    material.metallic = metallic;
    material.perceptual_roughness = roughness;
    material.double_sided = true;
    return material;
}

image::RadianceImage panorama(float radiance)
{
    image::RadianceImage image{16, 8, 3, std::vector<float>(16 * 8 * 3, radiance)};
    return image;
}

Camera looking(const glm::vec3& from, const glm::vec3& at, float fov)
{
    Camera camera;
    camera.position = from;
    camera.back = glm::normalize(from - at);
    camera.right = glm::normalize(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), camera.back));
    camera.up = glm::cross(camera.back, camera.right);
    camera.vertical_fov = fov;
    return camera;
}

glm::mat4 moved(const glm::vec3& by)
{
    return glm::translate(glm::mat4(1.0f), by);
}

scene::Scene ball_on_plane(float roughness)
{
    scene::Scene scene;
    add(scene, scene::make_plane(2.0f, 1), surface(0.4f, 0.0f, 0.8f));
    add(scene, scene::make_sphere(0.5f, 64, 32), surface(0.8f, 1.0f, roughness), moved({0.0f, 0.5f, 0.0f}));
    return scene;
}

// Where a metal ball touches a plane under small bright lights, pictures without bounces are a third off. (Goal: 5 %.)
TEST(LightWitness, AContactIsDark)
{
    const image::RadianceImage studio = environment::make_builtin("studio", {256});
    Settings settings = small_settings(64, 48, looking({0.0f, 0.7f, 2.6f}, {0.0f, 0.25f, 0.0f}, 0.5f));
    settings.bounces = 8;
    settings.passes = 8;
    const LightPair pair = draw_and_trace(ball_on_plane(0.4f), &studio, settings, 128);
    const double cut = 3.0 * pair.mean(pair.truth);
    const double whole = pair.error(cut), contact = pair.error(cut, [](int x, int y) {
        return std::abs(x - 32) < 11 && std::abs(y - 35) < 6;
    });
    std::printf("whole %.4f, around the contact %.4f, mean %.4f\n", whole, contact, pair.ratio());
    EXPECT_NEAR(pair.ratio(), 1.0, 0.03);
    EXPECT_LT(whole, 0.12);
    EXPECT_LT(contact, 0.4);
}

// A box from corner to corner, or a rectangle where it has no thickness.
scene::Mesh slab(const glm::vec3& a, const glm::vec3& b)
{
    const glm::vec3 middle = 0.5f * (a + b), half = 0.5f * (b - a);
    scene::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0f, 1.0f}) {
            const int next = (axis + 1) % 3, last = (axis + 2) % 3;
            if (half[next] <= 0.0f || half[last] <= 0.0f || (half[axis] <= 0.0f && sign > 0.0f))
                continue;
            const auto first = static_cast<unsigned>(mesh.positions.size());
            glm::vec3 u(0.0f), v(0.0f), n(0.0f);
            n[axis] = sign, u[next] = sign, v[last] = 1.0f;
            for (const glm::vec3& corner : {n - u - v, n + u - v, n + u + v, n - u + v}) {
                mesh.positions.push_back(middle + half * corner);
                mesh.normals.push_back(n);
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
            mesh.triangles.push_back({first, first + 2, first + 3});
        }
    return mesh;
}

// A closed chamber on a sunlit floor, seen from inside: walls `thick` metres thick, or without thickness.
scene::Scene chamber(float thick, bool sunk)
{
    scene::Scene scene;
    add(scene, scene::make_plane(4.0f, 1), surface(0.8f, 0.0f, 1.0f));
    const float low = sunk ? -0.05f : 0.0f, far = -2.0f - thick;
    const glm::vec3 walls[][2] = {{{0.0f, low, -1.0f}, {thick, 1.0f, 1.0f}},
                                  {{far, low, -1.0f}, {-2.0f, 1.0f, 1.0f}},
                                  {{far, low, 1.0f}, {thick, 1.0f, 1.0f + thick}},
                                  {{far, low, -1.0f - thick}, {thick, 1.0f, -1.0f}},
                                  {{far, 1.0f, -1.0f - thick}, {thick, 1.0f + thick, 1.0f + thick}}};
    for (const auto& [a, b] : walls)
        add(scene, slab(a, b), surface(0.7f, 0.0f, 0.9f));
    return scene;
}

double largest(const image::RadianceImage& image)
{
    double most = 0.0;
    for (std::size_t i = 0; i < image.values.size(); ++i)
        if (i % 4 != 3)
            most = std::max(most, static_cast<double>(image.values[i]));
    return most;
}

TEST(LightWitness, NoLightLeaksUnderAWall)
{
    const image::RadianceImage white = panorama(1.0f);
    Settings settings = small_settings(64, 48, looking({-1.4f, 0.5f, 0.3f}, {0.0f, 0.05f, 0.0f}, 0.7f));
    settings.bounces = 8;
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = glm::normalize(glm::vec3(-1.0f, -0.6f, 0.1f));
    sun.intensity = glm::vec3(10.0f);
    settings.lights = {sun};
    for (const float thick : {0.0f, 0.05f})
        for (const bool sunk : {false, true}) {
            SCOPED_TRACE(::testing::Message() << thick << (sunk ? " sunk" : ""));
            const LightPair pair = draw_and_trace(chamber(thick, sunk), &white, settings, 4);
            EXPECT_EQ(pair.mean(pair.truth), 0.0);
            EXPECT_LT(pair.mean(pair.picture), 5e-4); // the floor outside: 1.6
            EXPECT_LT(largest(pair.picture), 0.05);
        }
}

// A ball of 120 triangles with smooth normals under a sun: directions below a triangle, but above the smooth surface, carry
// no light.
TEST(LightWitness, ACoarseBallHasNeitherAcneNorDarkRims)
{
    const image::RadianceImage dim = panorama(0.3f);
    Settings settings = small_settings(60, 60, front_camera(1.2f));
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = glm::normalize(glm::vec3(-1.0f, -0.5f, -0.3f));
    sun.intensity = glm::vec3(3.0f);
    settings.lights = {sun};
    settings.passes = 4;
    for (const int segments : {10, 40})
        for (const int bounces : {1, 8}) {
            scene::Scene scene;
            add(scene, scene::make_sphere(0.5f, segments, segments / 2), surface(0.6f, 0.0f, 0.7f));
            settings.bounces = bounces;
            const LightPair pair = draw_and_trace(scene, &dim, settings, 128);
            const auto rim = [&](int x, int y) {
                const double r = std::hypot(x + 0.5 - 30.0, y + 0.5 - 30.0) / 25.0;
                return r > 0.8 && pair.truth.pixel(x, y)[3] >= 1.0f;
            };
            const auto inside = [&](int x, int y) { return pair.truth.pixel(x, y)[3] >= 1.0f; };
            EXPECT_NEAR(pair.ratio(), 1.0, 0.003);
            EXPECT_LT(pair.error(10.0, inside), 0.01);
            EXPECT_LT(pair.error(10.0, rim), 0.012);
        }
}

// Two mirrors face each other, with a ball between them.
TEST(LightWitness, MirrorsBetweenMirrors)
{
    const image::RadianceImage studio = environment::make_builtin("studio", {256});
    for (const float roughness : {0.0f, 0.2f}) {
        scene::Scene scene;
        const scene::Material mirror = surface(0.9f, 1.0f, roughness);
        add(scene, facing_square(1.0f, -0.6f), mirror);
        add(scene, facing_square(1.0f, -0.6f), mirror,
            glm::rotate(glm::mat4(1.0f), 3.1415927f, {0.0f, 1.0f, 0.0f}));
        scene::Material red = surface(0.5f, 0.0f, 0.6f);
        red.base_color = {0.7f, 0.2f, 0.1f, 1.0f};
        add(scene, scene::make_sphere(0.25f, 32, 16), red);
        Settings settings = small_settings(48, 36, looking({1.4f, 0.5f, 0.5f}, {0.0f, 0.0f, -0.2f}, 0.6f));
        settings.passes = 8;
        for (int bounces = 1; bounces <= 4; ++bounces) {
            settings.bounces = bounces;
            const LightPair pair = draw_and_trace(scene, &studio, settings, 128);
            const double error = pair.error(3.0 * pair.mean(pair.truth));
            std::printf("mirrors %.1f, %d bounces: mean %.4f, error %.4f\n", static_cast<double>(roughness),
                        bounces, pair.ratio(), error);
            EXPECT_NEAR(pair.ratio(), 1.0, 0.06);
            EXPECT_LT(error, 0.22);
        }
    }
}

// The lower half of a sphere, open above.
scene::Mesh bowl()
{
    scene::Mesh mesh = scene::make_sphere(0.5f, 48, 24);
    std::erase_if(mesh.triangles, [&](const glm::uvec3& t) {
        return mesh.positions[t.x].y > 1e-4f || mesh.positions[t.y].y > 1e-4f ||
               mesh.positions[t.z].y > 1e-4f;
    });
    return mesh;
}

TEST(LightWitness, WhiteThingsInAWhiteFurnace)
{
    const image::RadianceImage white = panorama(1.0f);
    for (const bool hollow : {false, true})
        for (const glm::vec2 kind :
             {glm::vec2(0.0f, 1.0f), glm::vec2(1.0f, 0.0f), glm::vec2(1.0f, 0.3f), glm::vec2(1.0f, 1.0f)}) {
            scene::Scene scene;
            add(scene, hollow ? bowl() : scene::make_sphere(0.5f, 48, 24), surface(1.0f, kind.x, kind.y));
            Settings settings =
                small_settings(48, 36, looking({0.0f, 2.0f, 1.0f}, {0.0f, -0.1f, 0.0f}, 0.5f));
            for (const int bounces : hollow ? std::vector<int>{1, 2, 8} : std::vector<int>{1, 8}) {
                settings.bounces = bounces;
                const LightPair pair = draw_and_trace(scene, &white, settings, 64);
                SCOPED_TRACE(::testing::Message() << (hollow ? "bowl" : "ball") << ", metal " << kind.x
                                                  << ", roughness " << kind.y << ", bounces " << bounces);
                EXPECT_NEAR(pair.ratio(), 1.0, !hollow ? 0.005 : kind.x > 0.0f ? 0.06 : 0.015);
                if (!hollow) {
                    EXPECT_GT(pair.mean(pair.picture), 0.9); // less than 1 where it covers pixels in part
                }
            }
        }
}

image::RadianceImage scaled(float scale, const glm::vec3& offset)
{
    scene::Scene scene = ball_on_plane(0.3f);
    for (scene::Instance& instance : scene.instances)
        instance.transform =
            moved(offset) * glm::scale(glm::mat4(1.0f), glm::vec3(scale)) * instance.transform;
    const environment::Environment studio =
        environment::make_environment(environment::make_panorama(environment::make_builtin("studio", {256})));
    Settings settings = small_settings(64, 48, looking({0.0f, 0.7f, 2.6f}, {0.0f, 0.25f, 0.0f}, 0.5f));
    settings.camera.position = offset + scale * settings.camera.position;
    settings.bounces = 4;
    settings.passes = 4;
    return draw(scene, &studio, settings).radiance;
}

// Relative root mean square difference.
double difference(const image::RadianceImage& a, const image::RadianceImage& b)
{
    double squares = 0.0, sum = 0.0, values = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double x = static_cast<double>(a.values[i]), y = static_cast<double>(b.values[i]);
        squares += (x - y) * (x - y), sum += y, values += 1.0;
    }
    return std::sqrt(squares * values) / sum;
}

// Cells of the cache are powers of two wide, so that other scales have other ones, and other noise.
TEST(LightWitness, IsTheSameAtEveryScale)
{
    const image::RadianceImage one = scaled(1.0f, glm::vec3(0.0f));
    EXPECT_LT(difference(scaled(0x1p-10f, glm::vec3(0.0f)), one), 1e-5);
    EXPECT_LT(difference(scaled(0x1p10f, glm::vec3(0.0f)), one), 1e-5);
    for (const float scale : {1e-3f, 1e3f, 1e-6f, 1e6f})
        EXPECT_LT(difference(scaled(scale, glm::vec3(0.0f)), one), 0.03) << scale;
    EXPECT_LT(difference(scaled(1.0f, glm::vec3(100.0f)), one), 0.01);
    EXPECT_LT(difference(scaled(1e3f, glm::vec3(1e5f)), one), 0.04);
}

} // namespace
} // namespace lambent::draw::testing
