#include "scene/builtin/builtin.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lambent::scene {
namespace {

TEST(Builtin, NamesAreKnown)
{
    for (const char* name : {"sphere", "teapot", "plane", "report", "painted", "grid", "furnace"})
        EXPECT_TRUE(is_builtin(name)) << name;
    EXPECT_EQ(builtin_names().size(), 7u);
    EXPECT_FALSE(is_builtin("Sphere"));
    EXPECT_FALSE(is_builtin(""));
    EXPECT_THROW(make_builtin("cube"), Error);
}

TEST(Builtin, EveryIndexLeadsSomewhere)
{
    for (const std::string_view name : builtin_names()) {
        const Scene scene = make_builtin(name);
        ASSERT_FALSE(scene.instances.empty()) << name;
        for (const Instance& instance : scene.instances) {
            EXPECT_LT(static_cast<std::size_t>(instance.mesh), scene.meshes.size());
            EXPECT_LT(instance.material, static_cast<int>(scene.materials.size()));
        }
        for (const Mesh& mesh : scene.meshes) {
            EXPECT_LT(static_cast<std::size_t>(mesh.material), scene.materials.size());
            EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
            for (const glm::uvec3 t : mesh.triangles)
                EXPECT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
        }
    }
}

TEST(Builtin, SphereAndTeapotStandOnTheGround)
{
    const Bounds sphere = bounds(make_builtin("sphere"));
    EXPECT_NEAR(sphere.low.y, 0.0f, 1e-6f);
    EXPECT_NEAR(sphere.high.y, 1.0f, 1e-6f);
    EXPECT_NEAR(sphere.high.x, 0.5f, 1e-3f);
    const Bounds teapot = bounds(make_builtin("teapot"));
    EXPECT_NEAR(teapot.low.y, 0.0f, 1e-6f);
    EXPECT_NEAR(teapot.high.x - teapot.low.x, 0.3f, 0.01f);
    const Bounds plane = bounds(make_builtin("plane"));
    EXPECT_EQ(plane.low, glm::vec3(-1, 0, -1));
    EXPECT_EQ(plane.high, glm::vec3(1, 0, 1));
}

TEST(Builtin, ThePaintedSphereHasColoursFromTextures)
{
    const Scene scene = make_builtin("painted");
    ASSERT_EQ(scene.images.size(), 2u);
    for (const Material& material : scene.materials) {
        EXPECT_FALSE(material.phong.diffuse);
        ASSERT_GE(material.base_color_texture.image, 0);
        EXPECT_LT(material.base_color_texture.image, 2);
    }
    for (const image::CodeImage& image : scene.images)
        EXPECT_EQ(image.bytes.size(), static_cast<std::size_t>(image.width * image.height * 4));
    // --kd takes the textures' place.
    BuiltinOptions options;
    options.diffuse = glm::vec3(0.5f);
    const Scene plain = make_builtin("painted", options);
    EXPECT_EQ(plain.materials[0].phong.diffuse, glm::vec3(0.5f));
}

TEST(Builtin, TheReportStandsOnItsPlaneUnderThreeLights)
{
    const Scene scene = make_builtin("report");
    ASSERT_EQ(scene.instances.size(), 3u);
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
    EXPECT_NEAR(glm::length(scene.lights[0].direction), 1.0f, 1e-6f);
    for (std::size_t i : {1u, 2u}) {
        EXPECT_EQ(scene.lights[i].kind, LightKind::point);
        EXPECT_GT(scene.lights[i].position.y, 0.0f);
        EXPECT_LT(scene.lights[i].position.y, 0.2f);
    }
    EXPECT_NEAR(bounds(scene).low.y, 0.0f, 1e-6f);
    for (const Material& material : scene.materials)
        EXPECT_EQ(material.phong.exponent, 100.0f);
    // Neither shape stands in the other.
    const auto box = [&](std::size_t instance) {
        Scene alone = scene;
        alone.instances = {scene.instances[instance]};
        return bounds(alone);
    };
    EXPECT_LT(box(0).high.x, box(1).low.x);
    EXPECT_NEAR(box(1).low.y, 0.0f, 1e-6f);
}

TEST(Builtin, TheGridRunsThroughRoughnessAndMetallic)
{
    const Scene scene = make_builtin("grid");
    ASSERT_EQ(scene.instances.size(), 49u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(triangle_count(scene), 49u * 1444u);
    for (const Instance& instance : scene.instances) {
        const Material& material = scene.materials.at(static_cast<std::size_t>(instance.material));
        // Spacing 0.25 m, centred: columns and rows from -3 to 3.
        const float column = instance.transform[3].x / 0.25f + 3.0f;
        const float row = instance.transform[3].y / 0.25f + 3.0f;
        EXPECT_NEAR(material.perceptual_roughness, column / 6.0f, 1e-5f);
        EXPECT_NEAR(material.metallic, row / 6.0f, 1e-5f);
        EXPECT_EQ(instance.transform[3].z, 0.0f);
        EXPECT_EQ(material.base_color, glm::vec4(1.0f, 0.766f, 0.336f, 1.0f));
    }
    const Bounds box = bounds(scene);
    EXPECT_NEAR(box.high.x, 0.75f + 0.1f, 1e-3f);
    EXPECT_NEAR(box.low.y, -0.75f - 0.1f, 1e-3f);
}

TEST(Builtin, TheFurnaceIsWhite)
{
    const Scene scene = make_builtin("furnace");
    ASSERT_EQ(scene.instances.size(), 33u);
    const auto material = [&](std::size_t i) {
        return scene.materials.at(static_cast<std::size_t>(scene.instances[i].material));
    };
    EXPECT_EQ(material(0).base_color, glm::vec4(1));
    EXPECT_EQ(material(0).metallic, 0.0f);
    EXPECT_EQ(material(0).perceptual_roughness, 0.0f);
    EXPECT_NEAR(material(12).perceptual_roughness, 0.1f, 1e-6f);
    EXPECT_EQ(material(12).metallic, 0.5f);
    EXPECT_EQ(material(32).metallic, 1.0f);
    EXPECT_EQ(material(32).perceptual_roughness, 1.0f);
}

TEST(Builtin, OptionsReachEveryMaterial)
{
    BuiltinOptions options;
    options.diffuse = glm::vec3(0.1f, 0.2f, 0.3f);
    options.exponent = 15625.0f;
    const Scene plain = make_builtin("report");
    const Scene changed = make_builtin("report", options);
    ASSERT_EQ(plain.materials.size(), changed.materials.size());
    for (std::size_t i = 0; i < plain.materials.size(); ++i) {
        EXPECT_EQ(changed.materials[i].phong.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
        EXPECT_EQ(changed.materials[i].phong.exponent, 15625.0f);
        EXPECT_EQ(changed.materials[i].phong.specular, plain.materials[i].phong.specular);
        EXPECT_EQ(changed.materials[i].perceptual_roughness, plain.materials[i].perceptual_roughness);
    }
    options.specular = glm::vec3(0.9f);
    EXPECT_EQ(make_builtin("teapot", options).materials[0].phong.specular, glm::vec3(0.9f));
}

TEST(Builtin, DensityChangesTheNumberOfTriangles)
{
    BuiltinOptions half;
    half.density = 0.5f;
    // 256 x 128 and 128 x 64: 2 segments (rings - 1)
    EXPECT_EQ(triangle_count(make_builtin("sphere")), 2u * 256u * 127u);
    EXPECT_EQ(triangle_count(make_builtin("sphere", half)), 2u * 128u * 63u);
    half.density = 1.0f / 16.0f;
    EXPECT_GT(triangle_count(make_builtin("report", half)), 0u);
}

TEST(Builtin, OptionsOutsideTheirRangeAreRefused)
{
    const auto failure = [](const BuiltinOptions& options) {
        try {
            make_builtin("sphere", options);
        } catch (const Error& error) {
            return error.failure() == Failure::usage;
        }
        return false;
    };
    BuiltinOptions options;
    options.density = 0.0f;
    EXPECT_TRUE(failure(options));
    options.density = 100.0f;
    EXPECT_TRUE(failure(options));
    for (const float exponent : {0.0f, -1.0f, 1.1e6f, std::nanf("")}) {
        options = {};
        options.exponent = exponent;
        EXPECT_TRUE(failure(options)) << exponent;
    }
    options = {};
    options.specular = glm::vec3(0, -1, 0);
    EXPECT_TRUE(failure(options));
    options = {};
    options.diffuse = glm::vec3(0, std::nanf(""), 0);
    EXPECT_TRUE(failure(options));
}

} // namespace
} // namespace lambent::scene
