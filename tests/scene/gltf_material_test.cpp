// Materials, textures, samplers.
#include "tests/scene/gltf_builder.h"
#include "tests/scene/png_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lambent::scene::test {
namespace {

// A triangle with texture coordinates, one material, and `images` one-pixel textures.
GltfBuilder with_material(const json& material, int images = 0)
{
    GltfBuilder builder = triangle();
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = builder.add_vec2({0, 0, 1, 0, 0, 1});
    primitive["attributes"]["TEXCOORD_1"] = builder.add_vec2({0, 0, 1, 0, 0, 1});
    primitive["material"] = 0;
    builder.document["materials"] = json::array({material});
    for (int i = 0; i < images; ++i) {
        const auto red = static_cast<std::uint16_t>(i);
        builder.add_to("images", {{"bufferView", builder.add_view(make_png({1, 1, 8, {red, 0, 0, 255}}))}});
        builder.add_to("textures", {{"source", i}});
    }
    return builder;
}

Material read(const GltfBuilder& builder, Warnings* warnings = nullptr)
{
    return load(builder, warnings).materials.at(0);
}

TEST(GltfMaterial, EmptyMaterialHasTheDefaults)
{
    const Material material = read(with_material(json::object()));
    EXPECT_EQ(material.base_color, glm::vec4(1));
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.perceptual_roughness, 1.0f);
    EXPECT_EQ(material.emissive, glm::vec3(0));
    EXPECT_EQ(material.normal_scale, 1.0f);
    EXPECT_EQ(material.occlusion_strength, 1.0f);
    EXPECT_EQ(material.base_color_texture.image, -1);
    EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(material.alpha_cutoff, 0.5f);
    EXPECT_FALSE(material.double_sided);
    EXPECT_FALSE(material.unlit);
    EXPECT_FALSE(material.phong.diffuse || material.phong.specular || material.phong.exponent);
}

TEST(GltfMaterial, CoatsAreRead)
{
    GltfBuilder builder = with_material({{"extensions",
                                          {{"KHR_materials_clearcoat",
                                            {{"clearcoatFactor", 0.75},
                                             {"clearcoatRoughnessFactor", 0.25},
                                             {"clearcoatTexture", {{"index", 0}}},
                                             {"clearcoatRoughnessTexture", {{"index", 1}, {"texCoord", 1}}},
                                             {"clearcoatNormalTexture", {{"index", 2}, {"scale", 0.5}}}}}}}},
                                        3);
    builder.document["extensionsRequired"] = {"KHR_materials_clearcoat"};
    const Material material = read(builder);
    EXPECT_EQ(material.coat, 0.75f);
    EXPECT_EQ(material.coat_roughness, 0.25f);
    EXPECT_EQ(material.coat_texture.image, 0);
    EXPECT_EQ(material.coat_roughness_texture.image, 1);
    EXPECT_EQ(material.coat_roughness_texture.texcoord, 1);
    EXPECT_EQ(material.coat_normal_texture.image, 2);
    EXPECT_EQ(material.coat_normal_scale, 0.5f);
    EXPECT_EQ(read(with_material(json::object())).coat, 0.0f) << "without the extension there is none";
}

TEST(GltfMaterial, AllFactorsAreRead)
{
    const Material material = read(with_material(
        {{"name", "brass"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"metallicFactor", 0.5}, {"roughnessFactor", 0.6}}},
         {"emissiveFactor", {0.5, 0.25, 1}},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.75},
         {"doubleSided", true}}));
    EXPECT_EQ(material.name, "brass");
    EXPECT_EQ(material.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.metallic, 0.5f);
    EXPECT_EQ(material.perceptual_roughness, 0.6f);
    EXPECT_EQ(material.emissive, glm::vec3(0.5f, 0.25f, 1));
    EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(material.alpha_cutoff, 0.75f);
    EXPECT_TRUE(material.double_sided);
}

TEST(GltfMaterial, EmissiveStrengthAndUnlit)
{
    const Material material =
        read(with_material({{"emissiveFactor", {0.5, 0.25, 1}},
                            {"alphaMode", "BLEND"},
                            {"extensions",
                             {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
                              {"KHR_materials_unlit", json::object()}}}}));
    EXPECT_EQ(material.emissive, glm::vec3(2, 1, 4));
    EXPECT_TRUE(material.unlit);
    EXPECT_EQ(material.alpha_mode, AlphaMode::blend);
}

TEST(GltfMaterial, EveryTextureFindsItsSlot)
{
    const GltfBuilder builder =
        with_material({{"pbrMetallicRoughness",
                        {{"baseColorTexture", {{"index", 4}}},
                         {"metallicRoughnessTexture", {{"index", 3}, {"texCoord", 1}}}}},
                       {"normalTexture", {{"index", 2}, {"scale", 0.5}}},
                       {"occlusionTexture", {{"index", 1}, {"strength", 0.25}}},
                       {"emissiveTexture", {{"index", 0}}}},
                      5);
    const Scene scene = load(builder);
    const Material& material = scene.materials.at(0);
    // The red of the one pixel says which image it is.
    const auto red = [&](const TextureUse& use) {
        return scene.images.at(static_cast<std::size_t>(use.image)).bytes.at(0);
    };
    EXPECT_EQ(scene.images.size(), 5u);
    EXPECT_EQ(red(material.base_color_texture), 4);
    EXPECT_EQ(red(material.metallic_roughness_texture), 3);
    EXPECT_EQ(red(material.normal_texture), 2);
    EXPECT_EQ(red(material.occlusion_texture), 1);
    EXPECT_EQ(red(material.emissive_texture), 0);
    EXPECT_EQ(material.metallic_roughness_texture.texcoord, 1);
    EXPECT_EQ(material.base_color_texture.texcoord, 0);
    EXPECT_EQ(material.normal_scale, 0.5f);
    EXPECT_EQ(material.occlusion_strength, 0.25f);
}

TEST(GltfMaterial, SamplersAreTranslated)
{
    const auto sampler = [](const json& source) {
        GltfBuilder builder = with_material({{"emissiveTexture", {{"index", 0}}}}, 1);
        builder.document["textures"][0]["sampler"] = 0;
        builder.document["samplers"] = json::array({source});
        return read(builder).emissive_texture.sampler;
    };
    const Sampler plain = sampler(json::object());
    EXPECT_EQ(plain.wrap_u, Wrap::repeat);
    EXPECT_EQ(plain.wrap_v, Wrap::repeat);
    EXPECT_FALSE(plain.magnify_nearest);
    EXPECT_FALSE(plain.minify_nearest);
    EXPECT_FALSE(plain.nearest_mipmap);
    EXPECT_TRUE(plain.mipmapped);
    const Sampler other =
        sampler({{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9728}});
    EXPECT_EQ(other.wrap_u, Wrap::clamp_to_edge);
    EXPECT_EQ(other.wrap_v, Wrap::mirrored_repeat);
    EXPECT_TRUE(other.magnify_nearest);
    EXPECT_TRUE(other.minify_nearest);
    EXPECT_FALSE(other.mipmapped);
    // NEAREST_MIPMAP_NEAREST, LINEAR_MIPMAP_NEAREST, NEAREST_MIPMAP_LINEAR, LINEAR_MIPMAP_LINEAR, LINEAR
    const bool nearest[] = {true, false, true, false, false};
    const bool nearest_level[] = {true, true, false, false, false};
    const bool mipmapped[] = {true, true, true, true, false};
    const int codes[] = {9984, 9985, 9986, 9987, 9729};
    for (std::size_t i = 0; i < std::size(codes); ++i) {
        EXPECT_EQ(sampler({{"minFilter", codes[i]}}).minify_nearest, nearest[i]) << codes[i];
        EXPECT_EQ(sampler({{"minFilter", codes[i]}}).nearest_mipmap, nearest_level[i]) << codes[i];
        EXPECT_EQ(sampler({{"minFilter", codes[i]}}).mipmapped, mipmapped[i]) << codes[i];
    }
    EXPECT_FALSE(sampler({{"magFilter", 9729}}).magnify_nearest);
}

GltfBuilder with_transform(const json& transform)
{
    return with_material(
        {{"emissiveTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}, 1);
}

glm::vec2 apply(const TextureUse& use, glm::vec2 uv)
{
    return glm::vec2(use.transform * glm::vec3(uv, 1.0f));
}

void expect_near(glm::vec2 a, glm::vec2 b)
{
    EXPECT_NEAR(a.x, b.x, 1e-6f);
    EXPECT_NEAR(a.y, b.y, 1e-6f);
}

TEST(GltfTextureTransform, TheExampleOfTheExtensionShowsTheLowerLeftQuadrant)
{
    // The lower left quadrant, says the text, turned clockwise by 90 degrees; v counts down.
    const TextureUse use =
        read(with_transform({{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}}))
            .emissive_texture;
    expect_near(apply(use, {0, 0}), {0, 1});
    expect_near(apply(use, {1, 0}), {0, 0.5f});
    expect_near(apply(use, {0, 1}), {0.5f, 1});
    expect_near(apply(use, {1, 1}), {0.5f, 0.5f});
}

TEST(GltfTextureTransform, TheOtherExampleTurnsTheImageOver)
{
    const TextureUse use = read(with_transform({{"offset", {0, 1}}, {"scale", {1, -1}}})).emissive_texture;
    expect_near(apply(use, {0.25f, 0.25f}), {0.25f, 0.75f});
}

TEST(GltfTextureTransform, ScaleComesBeforeRotationBeforeOffset)
{
    const TextureUse use =
        read(with_transform({{"offset", {10, 20}}, {"rotation", std::numbers::pi / 2}, {"scale", {2, 3}}}))
            .emissive_texture;
    // (1, 0) -> (2, 0) -> (0, -2) -> (10, 18); (0, 1) -> (0, 3) -> (3, 0) -> (13, 20)
    expect_near(apply(use, {1, 0}), {10, 18});
    expect_near(apply(use, {0, 1}), {13, 20});
}

TEST(GltfTextureTransform, TexCoordIsOverriddenAndDefaultsStay)
{
    EXPECT_EQ(read(with_transform({{"texCoord", 1}})).emissive_texture.texcoord, 1);
    EXPECT_EQ(read(with_transform({{"texCoord", 6}})).emissive_texture.texcoord, 6);
    const TextureUse use = read(with_transform(json::object())).emissive_texture;
    EXPECT_EQ(use.texcoord, 0);
    EXPECT_EQ(use.transform, glm::mat3(1.0f));
    EXPECT_EQ(complaint(with_transform({{"offset", {1}}})),
              "test.gltf: material 0, emissiveTexture, extensions, KHR_texture_transform: offset has 1 "
              "numbers, not 2: ignored");
}

TEST(GltfMaterial, FactorsOutsideTheirRangeAreClampedWithAWarning)
{
    Warnings warnings;
    const Material material =
        read(with_material({{"pbrMetallicRoughness", {{"roughnessFactor", 7}, {"metallicFactor", -1}}}}),
             &warnings);
    EXPECT_EQ(material.perceptual_roughness, 1.0f);
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_EQ(warnings,
              (Warnings{"test.gltf: material 0: metallicFactor -1 is outside its range: 0 is used",
                        "test.gltf: material 0: roughnessFactor 7 is outside its range: 1 is used"}));
}

TEST(GltfMaterial, TexturesThatCannotBeShownAreLeftOutWithAWarning)
{
    Warnings warnings;
    GltfBuilder builder = with_material({{"emissiveTexture", {{"index", 0}}}}, 1);
    builder.document["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
    EXPECT_EQ(read(builder, &warnings).emissive_texture.image, -1);
    EXPECT_TRUE(warned_once(warnings, "material 0: emissiveTexture: texture 0 has no PNG or JPEG image"));
}

TEST(GltfMaterial, TexturesWithoutTheirCoordinatesAreWarnedOf)
{
    GltfBuilder builder = with_material({{"emissiveTexture", {{"index", 0}, {"texCoord", 1}}}}, 1);
    builder.document["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_1");
    Warnings warnings;
    EXPECT_EQ(read(builder, &warnings).emissive_texture.image, 0);
    EXPECT_TRUE(warned_once(warnings, "1 primitives have textures but not their texture coordinates"));
}

TEST(GltfMaterial, WhatDoesNotExistIsNamedAndLeftOut)
{
    const auto broken = [](const std::function<void(json&)>& damage) {
        GltfBuilder builder = with_material({{"emissiveTexture", {{"index", 0}}}}, 1);
        damage(builder.document);
        return complaint(builder);
    };
    EXPECT_EQ(broken([](json& d) { d["meshes"][0]["primitives"][0]["material"] = 5; }),
              "test.gltf: material 5 does not exist: the default is used");
    EXPECT_EQ(broken([](json& d) { d["materials"][0]["emissiveTexture"]["index"] = 1; }),
              "test.gltf: material 0, emissiveTexture: texture 1 does not exist: the texture is left out");
    EXPECT_EQ(broken([](json& d) { d["textures"][0]["source"] = 1; }),
              "test.gltf: texture 0: image 1 does not exist: the texture is left out");
    EXPECT_EQ(broken([](json& d) { d["textures"][0]["sampler"] = 0; }),
              "test.gltf: material 0: sampler 0 does not exist: the default sampler is used");
    EXPECT_EQ(broken([](json& d) { d["images"][0]["bufferView"] = 55; }),
              "test.gltf: image 0: bufferView 55 does not exist: the texture is left out");
    EXPECT_EQ(broken([](json& d) { d["images"][0] = json::object(); }),
              "test.gltf: image 0: needs either a uri or a bufferView: the texture is left out");
    EXPECT_EQ(broken([](json& d) { d["materials"][0]["alphaMode"] = "GLASS"; }),
              "test.gltf: material 0: alphaMode \"GLASS\" is not defined by glTF: OPAQUE is used");
    EXPECT_EQ(broken([](json& d) {
                  d["textures"][0]["sampler"] = 0;
                  d["samplers"] = {{{"wrapS", 1}}};
              }),
              "test.gltf: sampler 0: wrap mode 1 is not defined by glTF: repeat is used");
    EXPECT_EQ(broken([](json& d) {
                  d["textures"][0]["sampler"] = 0;
                  d["samplers"] = {{{"magFilter", 9987}}};
              }),
              "test.gltf: sampler 0: magFilter 9987 is not defined by glTF: linear is used");
}

TEST(GltfMaterial, OnlyThoseDrawnAreKept)
{
    GltfBuilder builder = with_material({{"name", "unused"}});
    builder.document["materials"].push_back({{"name", "used"}});
    builder.document["meshes"][0]["primitives"][0]["material"] = 1;
    builder.add_primitive({{"attributes", {{"POSITION", 0}}}});
    const Scene scene = load(builder);
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[static_cast<std::size_t>(scene.meshes[0].material)].name, "used");
    const Material& other = scene.materials[static_cast<std::size_t>(scene.meshes[1].material)];
    EXPECT_EQ(other.name, "") << "the default material";
    EXPECT_EQ(other.base_color, glm::vec4(1));
}

} // namespace
} // namespace lambent::scene::test
