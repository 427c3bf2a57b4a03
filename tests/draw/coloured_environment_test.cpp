// An environment that is another colour in every direction: background, matte surfaces and mirrors agree where each is,
// whichever way they face and however it is turned.
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace lambent::draw {
namespace {

using glm::dvec3;
using std::numbers::pi;
using testing::pixel;

// Radiance 1 + d, a channel for each axis. Its irradiance is pi (1 + 2/3 N): the mean of 1 + d weighted by the cosine.
const environment::Environment& slopes()
{
    static const environment::Environment made =
        testing::environment_of(256, [](dvec3 d) { return glm::vec3(1.0 + d); });
    return made;
}

// Where in the environment as it was lies what is seen at d, after it has been turned about +Y, counter-clockwise seen
// from above.
dvec3 before_turning(dvec3 d, double angle)
{
    return dvec3(glm::rotate(glm::dmat4(1.0), -angle, dvec3(0, 1, 0)) * glm::dvec4(d, 0.0));
}

constexpr double turns[] = {0.0, 0.5 * pi, 0.7};

// The six axes, and between them one direction in each octant.
std::vector<dvec3> directions()
{
    std::vector<dvec3> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int octant = 0; octant < 8; ++octant) {
        const dvec3 d(octant & 1 ? 1 : -1, octant & 2 ? 2 : -2, octant & 4 ? 3 : -3);
        const dvec3 permuted[] = {d, {d.y, d.z, d.x}, {d.z, d.x, d.y}};
        all.push_back(glm::normalize(permuted[octant % 3]));
    }
    return all;
}

// Any unit vector square to d.
dvec3 beside(dvec3 d)
{
    return glm::normalize(glm::cross(std::fabs(d.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), d));
}

// What is seen from `view` of a square at the origin that faces `normal`.
glm::dvec4 seen(const scene::Material& material, dvec3 normal, dvec3 view, Settings settings)
{
    const dvec3 right = beside(normal);
    scene::Scene scene;
    testing::add(scene, testing::facing_square(1.0f, 0.0f), material,
                 glm::mat4(glm::dmat4(glm::dvec4(right, 0), glm::dvec4(glm::cross(normal, right), 0),
                                      glm::dvec4(normal, 0), glm::dvec4(0, 0, 0, 1))));
    settings.width = settings.height = 3;
    settings.background.kind = Background::Kind::none;
    settings.camera = testing::front_camera(0.01f);
    settings.camera.position = glm::vec3(10.0 * view);
    settings.camera.right = glm::vec3(beside(view));
    settings.camera.up = glm::vec3(glm::cross(view, beside(view)));
    settings.camera.back = glm::vec3(view);
    return pixel(testing::draw(scene, &slopes(), settings), 1, 1);
}

std::string trace(dvec3 d, double turn)
{
    return ::testing::PrintToString(d.x) + ' ' + ::testing::PrintToString(d.y) + ' ' +
           ::testing::PrintToString(d.z) + " turned by " + ::testing::PrintToString(turn);
}

void expect_near(glm::dvec4 c, dvec3 expected, double tolerance)
{
    EXPECT_NEAR(c.r, expected.r, tolerance);
    EXPECT_NEAR(c.g, expected.g, tolerance);
    EXPECT_NEAR(c.b, expected.b, tolerance);
}

TEST(ColouredEnvironment, BackgroundShowsItsDirection)
{
    scene::Scene nothing;
    nothing.materials.emplace_back();
    for (const double turn : turns)
        for (const dvec3 d : directions()) {
            Settings settings;
            settings.width = settings.height = 3;
            settings.environment_rotation = static_cast<float>(turn);
            settings.camera.vertical_fov = 0.01f;
            settings.camera.right = glm::vec3(beside(-d));
            settings.camera.up = glm::vec3(glm::cross(-d, beside(-d)));
            settings.camera.back = glm::vec3(-d);
            SCOPED_TRACE(trace(d, turn));
            expect_near(pixel(testing::draw(nothing, &slopes(), settings), 1, 1),
                        1.0 + before_turning(d, turn), 0.01);
        }
}

// Of an exponent so high that nothing is reflected at grazing angles.
TEST(ColouredEnvironment, MatteSurfacesShowTheMeanAroundTheirNormal)
{
    const dvec3 Kd(0.5, 0.25, 0.75);
    scene::Material material;
    material.phong = scene::PhongMaterial{glm::vec3(Kd), glm::vec3(0.0f), 1e6f};
    for (const double turn : turns)
        for (const dvec3 N : directions()) {
            Settings settings;
            settings.model = Model::phong;
            settings.environment_rotation = static_cast<float>(turn);
            SCOPED_TRACE(trace(N, turn));
            expect_near(seen(material, N, N, settings), Kd * (1.0 + 2.0 / 3.0 * before_turning(N, turn)),
                        0.002);
        }
}

// A half of the angle between where a mirror is seen from and what it shows.
constexpr double tilt = 0.6;

dvec3 normal_of_mirror(dvec3 shown)
{
    return std::cos(tilt) * shown + std::sin(tilt) * beside(shown);
}

dvec3 view_of_mirror(dvec3 shown)
{
    return std::cos(2.0 * tilt) * shown + std::sin(2.0 * tilt) * beside(shown);
}

TEST(ColouredEnvironment, MirrorsShowTheMirroredDirection)
{
    scene::Material mirror; // a white metal: F = 1 at every angle
    mirror.perceptual_roughness = 0.0f;
    for (const double turn : turns)
        for (const dvec3 R : directions()) {
            Settings settings;
            settings.environment_rotation = static_cast<float>(turn);
            SCOPED_TRACE(trace(R, turn));
            expect_near(seen(mirror, normal_of_mirror(R), view_of_mirror(R), settings),
                        1.0 + before_turning(R, turn), 0.01);
        }
}

// The report's mirror reflects 1 / (4 cos) of it. The first of its own 40 points is far out, where the density is next
// to nothing: that one reads the coarsest level, two texels that are near the mean.
TEST(ColouredEnvironment, TheReportsMirrorsShowTheMirroredDirection)
{
    scene::Material mirror;
    mirror.phong = scene::PhongMaterial{glm::vec3(0.0f), glm::vec3(1.0f), 1e6f};
    for (const MipLevel mip_level : {MipLevel::matched, MipLevel::report})
        for (const double turn : turns)
            for (const dvec3 R : directions()) {
                Settings settings;
                settings.model = Model::phong;
                settings.mip_level = mip_level;
                settings.environment_rotation = static_cast<float>(turn);
                SCOPED_TRACE(trace(R, turn));
                const double shown = mip_level == MipLevel::report ? 39.0 / 40.0 : 1.0;
                expect_near(4.0 * std::cos(tilt) *
                                seen(mirror, normal_of_mirror(R), view_of_mirror(R), settings),
                            1.0 + shown * before_turning(R, turn), 0.015);
            }
}

// The footprint of a pixel turns with everything else: a coarse picture of a sphere under an environment that is turned,
// and under one whose panorama was.
TEST(ColouredEnvironment, TurningItIsTurningItsPanorama)
{
    const auto stripes = [](dvec3 d) {
        return glm::vec3(1.0 + std::sin(12.0 * std::atan2(d.z, d.x)), 1.0 + std::sin(9.0 * d.y + 4.0 * d.x),
                         1.0 + d.z);
    };
    const environment::Environment plain = testing::environment_of(256, stripes);
    const environment::Environment turned =
        testing::environment_of(256, [&](dvec3 d) { return stripes(before_turning(d, 0.5 * pi)); });
    for (const Model model : {Model::ggx, Model::phong})
        for (const float roughness : {0.0f, 0.4f}) {
            if (model == Model::phong && roughness == 0.0f)
                continue; // picks single points of the stripes
            scene::Scene scene;
            scene::Material material;
            material.metallic = 0.8f;
            material.perceptual_roughness = roughness;
            testing::add(scene, scene::make_sphere(0.5f, 128, 64), material);
            Settings settings = testing::small_settings(20, 20, testing::front_camera(1.1f));
            settings.model = model;
            settings.background.kind = Background::Kind::blurred;
            settings.background.roughness = 0.3f;
            const Frame expected = testing::draw(scene, &turned, settings);
            settings.environment_rotation = static_cast<float>(0.5 * pi);
            const Frame frame = testing::draw(scene, &plain, settings);
            for (std::size_t i = 0; i < frame.radiance.values.size(); ++i)
                ASSERT_NEAR(frame.radiance.values[i], expected.radiance.values[i],
                            0.014f * (1.0f + expected.radiance.values[i]))
                    << i / 4 << ' ' << i % 4;
        }
}

} // namespace
} // namespace lambent::draw
