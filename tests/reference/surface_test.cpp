// What a ray finds where it meets a surface, from scenes whose points are known.
#include "reference/surface.h"
#include "reference/texture.h"
#include "tests/reference/traced.h"

#include <glm/ext/matrix_transform.hpp>

namespace lambent::reference {
namespace {

using namespace testing;
using view::TexelTransfer;

// What a ray from (x, y, 10) along -Z meets.
struct Met {
    scene::Scene scene;
    trace::Hit hit;
    Surface surface;
    bool culled = false;
    double opacity = 0.0;
};

Met meet(scene::Scene scene, float x, float y, view::Model model = view::Model::ggx,
         std::optional<float> roughness = std::nullopt)
{
    Met met;
    met.scene = std::move(scene);
    const trace::Visibility visibility(met.scene);
    const Surfaces surfaces(met.scene, model, TexelTransfer::srgb, roughness);
    met.hit = visibility.nearest({{x, y, 10.0f}, {0.0f, 0.0f, -1.0f}});
    EXPECT_TRUE(met.hit.found());
    met.surface = surfaces.at(met.hit, {0.0, 0.0, -1.0});
    met.culled = surfaces.is_culled(met.hit);
    met.opacity = surfaces.opacity(met.hit);
    return met;
}

void expect_vector(const glm::dvec3& seen, const glm::dvec3& expected, double error = 1e-6)
{
    EXPECT_LT(glm::length(seen - expected), error)
        << seen.x << ' ' << seen.y << ' ' << seen.z << ", expected " << expected.x << ' ' << expected.y << ' '
        << expected.z;
}

TEST(ReferenceSurface, ASphereHasItsNormals)
{
    // Halved along X, twice as deep along Z: the normal of x^2 / a^2 is x / a^2, along every axis.
    for (const glm::vec3& size :
         {glm::vec3(1.0f), glm::vec3(0.5f, 1.0f, 2.0f), glm::vec3(-1.0f, 1.0f, 1.5f)}) {
        scene::Scene scene = scene_of(scene::make_sphere(1.0f, 512, 256), metallic(0.5f, 0.0f, 0.5f));
        scene.instances[0].transform = glm::scale(glm::mat4(1.0f), size);
        const Met met = meet(scene, 0.2f, 0.3f);
        const glm::dvec3 p = met.surface.position, s(size);
        const glm::dvec3 normal = glm::normalize(p / (s * s));
        expect_vector(met.surface.normal, normal, 1e-3);
        expect_vector(met.surface.geometric, normal, 0.02);
        EXPECT_NEAR(p.x, 0.2, 1e-5);
        EXPECT_NEAR(p.x * p.x / (s.x * s.x) + p.y * p.y + p.z * p.z / (s.z * s.z), 1.0, 1e-3);
        EXPECT_TRUE(met.hit.front);
        expect_vector(met.surface.view, {0.0, 0.0, 1.0});
    }
}

TEST(ReferenceSurface, BacksFaceTheViewerAndAreCulledUnlessDoubleSided)
{
    scene::Scene scene = scene_of(facing_square(1.0f, 0.0f), metallic(0.5f, 0.0f, 0.5f));
    EXPECT_FALSE(meet(scene, 0.1f, 0.2f).culled);
    scene.instances[0].transform = glm::rotate(glm::mat4(1.0f), static_cast<float>(pi), {0.0f, 1.0f, 0.0f});
    const Met back = meet(scene, 0.1f, 0.2f);
    EXPECT_TRUE(back.culled);
    expect_vector(back.surface.normal, {0.0, 0.0, 1.0});
    expect_vector(back.surface.geometric, {0.0, 0.0, 1.0});
    scene.materials[0].double_sided = true;
    EXPECT_FALSE(meet(scene, 0.1f, 0.2f).culled);
}

// One texel that leans by (0.6, 0, 0.8) as codes, to within their steps.
scene::Scene leaning(glm::u8vec3 codes, float scale = 1.0f)
{
    scene::Material material = metallic(0.5f, 0.0f, 0.5f);
    material.normal_texture.image = 0;
    material.normal_scale = scale;
    material.double_sided = true;
    scene::Scene scene = scene_of(facing_square(1.0f, 0.0f), material);
    scene.images.push_back({1, 1, 4, 8, {codes.x, codes.y, codes.z, 255}});
    return scene;
}

glm::dvec3 decoded(double r, double g, double b, double scale = 1.0)
{
    return glm::normalize(
        glm::dvec3(scale * (2.0 * r / 255.0 - 1.0), scale * (2.0 * g / 255.0 - 1.0), 2.0 * b / 255.0 - 1.0));
}

TEST(ReferenceSurface, NormalMapsLeanAlongTangentAndBitangent)
{
    expect_vector(meet(leaning({204, 128, 230}), 0.1f, 0.2f).surface.normal, decoded(204, 128, 230));
    expect_vector(meet(leaning({128, 204, 230}), 0.1f, 0.2f).surface.normal, decoded(128, 204, 230));
    expect_vector(meet(leaning({204, 160, 230}, 0.5f), 0.1f, 0.2f).surface.normal,
                  decoded(204, 160, 230, 0.5));
}

TEST(ReferenceSurface, NormalMapsFollowTheirInstance)
{
    const glm::dvec3 n = decoded(204, 160, 230);
    scene::Scene scene = leaning({204, 160, 230});
    // The bitangent's sign turns the second component round.
    for (glm::vec4& t : scene.meshes[0].tangents)
        t.w = -1.0f;
    expect_vector(meet(scene, 0.1f, 0.2f).surface.normal, {n.x, -n.y, n.z});
    for (glm::vec4& t : scene.meshes[0].tangents)
        t.w = 1.0f;
    // Turned by a quarter: X to Y, Y to -X.
    scene.instances[0].transform =
        glm::rotate(glm::mat4(1.0f), static_cast<float>(0.5 * pi), {0.0f, 0.0f, 1.0f});
    expect_vector(meet(scene, 0.1f, 0.2f).surface.normal, {-n.y, n.x, n.z});
    // Mirrored: what leant to +X leans to -X, and what leant to +Y still does.
    scene.instances[0].transform = glm::scale(glm::mat4(1.0f), {-1.0f, 1.0f, 1.0f});
    expect_vector(meet(scene, 0.1f, 0.2f).surface.normal, {-n.x, n.y, n.z});
    // Larger: unit vectors all the same.
    scene.instances[0].transform = glm::scale(glm::mat4(1.0f), glm::vec3(3.0f));
    expect_vector(meet(scene, 0.1f, 0.2f).surface.normal, n);
}

TEST(ReferenceSurface, NormalsThatFaceAwayAreBentTowardsTheViewer)
{
    scene::Scene scene = scene_of(facing_square(1.0f, 0.0f), metallic(0.5f, 0.0f, 0.5f));
    scene.meshes[0].normals.assign(4, glm::normalize(glm::vec3(1.0f, 0.0f, -0.2f)));
    const Surface surface = meet(scene, 0.1f, 0.2f).surface;
    EXPECT_GT(glm::dot(surface.normal, surface.view), 0.0);
    EXPECT_NEAR(glm::length(surface.normal), 1.0, 1e-12);
    EXPECT_GT(surface.normal.x, 0.9);
    // One that faces the viewer at a cosine of 0.05 is left alone.
    const glm::vec3 grazing = glm::normalize(glm::vec3(0.6f, 0.8f, 0.05f));
    scene.meshes[0].normals.assign(4, grazing);
    expect_vector(meet(scene, 0.1f, 0.2f).surface.normal, grazing);
}

// One texel of a row of four each: roughness 0.2 by the first set, 0.6 by the second.
TEST(ReferenceSurface, TexturesTakeTheirSetOfCoordinates)
{
    scene::Material material = metallic(0.5f, 0.0f, 1.0f);
    material.metallic_roughness_texture.image = 0;
    scene::Scene scene = scene_of(facing_square(1.0f, 0.0f), material);
    scene.images.push_back({4, 1, 4, 8, {0, 0, 0, 255, 0, 51, 0, 255, 0, 153, 0, 255, 0, 255, 0, 255}});
    for (const int set : {0, 1}) {
        scene.meshes[0].texcoords[set].assign(4, {set == 0 ? 0.375f : 0.625f, 0.5f});
        scene.materials[0].metallic_roughness_texture.texcoord = set;
        EXPECT_NEAR(meet(scene, 0.1f, 0.2f).surface.material.alpha, set == 0 ? 0.04 : 0.36, 1e-6);
    }
}

TEST(ReferenceSurface, ColoursAreFactorTimesTextureTimesVertices)
{
    scene::Material material = metallic(0.5f, 0.25f, 0.5f);
    material.base_color_texture.image = 0;
    material.metallic_roughness_texture.image = 1;
    material.emissive = {2.0f, 3.0f, 4.0f};
    material.emissive_texture.image = 0;
    material.alpha_mode = scene::AlphaMode::blend;
    scene::Scene scene = scene_of(facing_square(1.0f, 0.0f), material);
    scene.images.push_back({1, 1, 4, 8, {255, 188, 0, 128}});
    scene.images.push_back({1, 1, 4, 8, {0, 204, 102, 255}});
    // Red from left to right: 0 to 1.
    scene.meshes[0].colors = {{0, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {0, 1, 1, 1}};
    const Met met = meet(scene, 0.5f, 0.1f);
    const double green = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4); // [IEC 61966-2-1]
    expect_vector(met.surface.material.base_color, {0.5 * 0.75, 0.5 * green, 0.0});
    expect_vector(emitted_by(met.surface, true), {2.0, 3.0 * green, 0.0});
    EXPECT_NEAR(met.surface.material.metallic, 0.25 * 0.4, 1e-6);
    EXPECT_NEAR(met.surface.material.alpha, std::pow(0.5 * 0.8, 2.0), 1e-6);
    EXPECT_NEAR(met.opacity, 128.0 / 255.0, 1e-6);
}

// A square whose texture of roughness goes up and down, and the same with one roughness and no texture.
TEST(ReferenceSurface, OneRoughnessIsThatOfAllMaterials)
{
    scene::Material material = metallic(0.7f, 0.0f, 0.9f);
    material.metallic_roughness_texture.image = 0;
    scene::Scene textured = scene_of(facing_square(1.0f, 0.0f), material);
    textured.images.push_back({2, 1, 4, 8, {0, 30, 255, 255, 0, 250, 80, 255}});
    const scene::Scene plain = scene_of(facing_square(1.0f, 0.0f), metallic(0.7f, 0.0f, 0.3f));
    EXPECT_NEAR(meet(textured, 0.1f, 0.2f, view::Model::ggx, 0.3f).surface.material.alpha, 0.09, 1e-7);
    EXPECT_NE(meet(textured, 0.1f, 0.2f).surface.material.alpha,
              meet(plain, 0.1f, 0.2f).surface.material.alpha);
    const image::RadianceImage light =
        panorama_of(16, [](const glm::dvec3& d) { return glm::dvec3(1.0) + 0.5 * d; });
    Settings settings = small_settings(8, 1.0f, 16);
    settings.seed = 3;
    const Result wanted = trace(plain, &light, settings);
    settings.roughness_override = 0.3f;
    EXPECT_EQ(trace(textured, &light, settings).radiance.values, wanted.radiance.values);
}

TEST(ReferenceSurface, OpacityIsByTheModeOfAlpha)
{
    scene::Scene scene = scene_of(facing_square(1.0f, 0.0f), metallic(0.5f, 0.0f, 0.5f));
    scene.materials[0].base_color.a = 0.3f;
    const auto opacity = [&](scene::AlphaMode mode, float cutoff) {
        scene.materials[0].alpha_mode = mode;
        scene.materials[0].alpha_cutoff = cutoff;
        return meet(scene, 0.1f, 0.2f).opacity;
    };
    EXPECT_EQ(opacity(scene::AlphaMode::opaque, 0.5f), 1.0);
    EXPECT_NEAR(opacity(scene::AlphaMode::blend, 0.5f), 0.3, 1e-6);
    EXPECT_EQ(opacity(scene::AlphaMode::mask, 0.5f), 0.0);
    EXPECT_EQ(opacity(scene::AlphaMode::mask, 0.3f), 1.0) << "at the cutoff it is there";
}

TEST(ReferenceSurface, ThePhongModelTakesWhatItIsGiven)
{
    const scene::Scene given =
        scene_of(facing_square(1.0f, 0.0f), phong({0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f}, 70.0f));
    const Surface surface = meet(given, 0.1f, 0.2f, view::Model::phong).surface;
    expect_vector(surface.phong.diffuse, {0.1, 0.2, 0.3});
    expect_vector(surface.phong.specular, {0.4, 0.5, 0.6});
    EXPECT_EQ(surface.phong.exponent, 70.0);
    // Otherwise of metal and roughness: the same peak as GGX, 2 / alpha^2 - 2.
    const Surface made =
        meet(scene_of(facing_square(1.0f, 0.0f), metallic(0.8f, 0.25f, 0.5f)), 0.1f, 0.2f, view::Model::phong)
            .surface;
    EXPECT_NEAR(made.phong.exponent, 2.0 / 0.0625 - 2.0, 1e-4);
    EXPECT_NEAR(made.phong.diffuse.x, 0.75 * 0.8, 1e-6);
    EXPECT_NEAR(made.phong.specular.x, 0.75 * 0.04 + 0.25 * 0.8, 1e-6);
}

double red(const scene::Sampler& sampler, double u, double v, const image::CodeImage& image)
{
    return read_texture(image, sampler, TexelTransfer::none, {u, v}).r;
}

// Four texels in a row, 0 51 102 255, so that 1/5 2/5 and 1 of full.
const image::CodeImage row = {4, 1, 4, 8, {0, 0, 0, 255, 51, 0, 0, 255, 102, 0, 0, 255, 255, 0, 0, 255}};

TEST(ReferenceTexture, IsReadBetweenTexelsOrAtTheNearest)
{
    scene::Sampler linear, nearest;
    nearest.magnify_nearest = true;
    const double shares[] = {0.0, 0.2, 0.4, 1.0};
    for (int x = 0; x < 4; ++x)
        EXPECT_NEAR(red(linear, (x + 0.5) / 4, 0.5, row), shares[x], 1e-12);
    EXPECT_NEAR(red(linear, 1.75 / 4, 0.5, row), 0.25, 1e-12);
    EXPECT_NEAR(red(linear, 3.0 / 4, 0.3, row), 0.7, 1e-12);
    EXPECT_NEAR(red(nearest, 1.99 / 4, 0.5, row), 0.2, 1e-12);
    EXPECT_NEAR(red(nearest, 2.01 / 4, 0.5, row), 0.4, 1e-12);
}

TEST(ReferenceTexture, WrapsAsTheSamplerSays)
{
    const auto with = [](scene::Wrap wrap) {
        scene::Sampler sampler;
        sampler.wrap_u = wrap;
        return sampler;
    };
    using enum scene::Wrap;
    // Half a texel to the left of the first: between it and its neighbour there.
    EXPECT_NEAR(red(with(repeat), 0.0, 0.5, row), 0.5, 1e-12);
    EXPECT_NEAR(red(with(mirrored_repeat), 0.0, 0.5, row), 0.0, 1e-12);
    EXPECT_NEAR(red(with(clamp_to_edge), -7.3, 0.5, row), 0.0, 1e-12);
    EXPECT_NEAR(red(with(clamp_to_edge), 7.3, 0.5, row), 1.0, 1e-12);
    for (const double turns : {-3.0, 1.0, 1000.0})
        EXPECT_NEAR(red(with(repeat), turns + 1.5 / 4, 0.5, row), 0.2, 1e-9);
    EXPECT_NEAR(red(with(mirrored_repeat), 1.0 + 0.5 / 4, 0.5, row), 1.0, 1e-12);
    EXPECT_NEAR(red(with(mirrored_repeat), 1.0 + 2.5 / 4, 0.5, row), 0.2, 1e-12);
    EXPECT_NEAR(red(with(mirrored_repeat), -1.5 / 4, 0.5, row), 0.2, 1e-12);
    EXPECT_NEAR(red(with(mirrored_repeat), 2.0 + 1.5 / 4, 0.5, row), 0.2, 1e-12);
    EXPECT_TRUE(std::isfinite(red(with(repeat), 1e300, -1e300, row)));
}

TEST(ReferenceTexture, CodesOfBothDepthsMeanLight)
{
    image::CodeImage deep{1, 1, 4, 16, std::vector<std::uint8_t>(8, 0)};
    const std::uint16_t code = 13107; // a fifth
    std::copy_n(reinterpret_cast<const std::uint8_t*>(&code), 2, deep.bytes.begin());
    const auto at = [](const image::CodeImage& image, TexelTransfer transfer) {
        return read_texture(image, {}, transfer, {0.3, 0.3}).r;
    };
    const image::CodeImage shallow{1, 1, 4, 8, {51, 51, 51, 51}};
    for (const image::CodeImage& image : {shallow, deep}) {
        EXPECT_NEAR(at(image, TexelTransfer::none), 0.2, 1e-12);
        EXPECT_NEAR(at(image, TexelTransfer::power_2_2), std::pow(0.2, 2.2), 1e-9);
        EXPECT_NEAR(at(image, TexelTransfer::srgb), std::pow(0.255 / 1.055, 2.4), 1e-9);
    }
    EXPECT_NEAR(read_texture(shallow, {}, TexelTransfer::srgb, {0.3, 0.3}).a, 0.2, 1e-12)
        << "alpha is linear";
}

} // namespace
} // namespace lambent::reference
