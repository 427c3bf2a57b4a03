// Surfaces that are partly there: how much of them is seen, and of what is behind.
#include "tests/reference/traced.h"

namespace lambent::reference {
namespace {

using namespace testing;

scene::Material layer(const glm::vec3& radiance, float alpha, scene::AlphaMode mode)
{
    scene::Material material = unlit(radiance, alpha);
    material.alpha_mode = mode;
    return material;
}

Result seen(const scene::Scene& scene)
{
    Settings settings = small_settings(16, 1.0f, 64);
    settings.bounces = 1;
    return trace(scene, nullptr, settings);
}

double coverage(const Result& result)
{
    double sum = 0.0;
    for (int y = 0; y < result.radiance.height; ++y)
        for (int x = 0; x < result.radiance.width; ++x)
            sum += static_cast<double>(result.radiance.pixel(x, y)[3]);
    return sum / (result.radiance.width * result.radiance.height);
}

// Each of `samples` is there or not: binomial.
void expect_coverage(const Result& result, double expected, double samples = 16.0 * 16.0 * 64.0)
{
    EXPECT_NEAR(coverage(result), expected,
                deviations * std::sqrt(expected * (1.0 - expected) / samples) + 1e-6);
}

using enum scene::AlphaMode;

TEST(ReferenceLayers, OneBlendedLayerIsItsShare)
{
    for (const float alpha : {0.0f, 0.1f, 0.5f, 0.9f, 1.0f}) {
        const Result result =
            seen(scene_of(facing_square(5.0f, 0.0f), layer({1.0f, 2.0f, 4.0f}, alpha, blend)));
        expect_light(result, static_cast<double>(alpha) * glm::dvec3(1.0, 2.0, 4.0));
        expect_coverage(result, static_cast<double>(alpha));
    }
}

TEST(ReferenceLayers, LayersBehindAreSeenThroughThoseInFront)
{
    scene::Scene scene = scene_of(facing_square(5.0f, 1.0f), layer({1.0f, 0.0f, 0.0f}, 0.5f, blend));
    add(scene, facing_square(5.0f, 0.5f), layer({0.0f, 1.0f, 0.0f}, 0.25f, blend));
    const Result two = seen(scene);
    expect_light(two, {0.5, 0.5 * 0.25, 0.0});
    expect_coverage(two, 1.0 - 0.5 * 0.75);
    add(scene, facing_square(5.0f, 0.0f), unlit({0.0f, 0.0f, 8.0f}));
    const Result three = seen(scene);
    expect_light(three, {0.5, 0.5 * 0.25, 0.5 * 0.75 * 8.0});
    expect_coverage(three, 1.0);
}

// Texture alpha 0 to 255 over four columns, nearest: those at or above the cutoff are there.
TEST(ReferenceLayers, MasksCutWhereAlphaIsBelowTheCutoff)
{
    scene::Material material = layer({3.0f, 3.0f, 3.0f}, 1.0f, mask);
    material.base_color_texture.image = 0;
    material.base_color_texture.sampler.magnify_nearest = true;
    material.alpha_cutoff = 128.0f / 255.0f;
    scene::Scene scene = scene_of(facing_square(0.5f, 0.0f), material);
    image::CodeImage codes{4, 1, 4, 8, std::vector<std::uint8_t>(16, 255)};
    codes.bytes[3] = 0, codes.bytes[7] = 127, codes.bytes[11] = 129;
    scene.images.push_back(codes);
    const Result result = seen(scene);
    for (int column = 0; column < 16; ++column) {
        const float there = column < 8 ? 0.0f : 1.0f;
        EXPECT_EQ(result.radiance.pixel(column, 5)[0], 3.0f * there) << column;
        EXPECT_EQ(result.radiance.pixel(column, 5)[3], there) << column;
    }
}

// What is seen without lighting is told apart: its share, and its light. In mirrors it is light as any other.
TEST(ReferenceLayers, SharesWithoutLightingAreKnown)
{
    scene::Material behind = metallic(0.0f, 1.0f, 1.0f);
    behind.emissive = glm::vec3(3.0f);
    scene::Scene scene = scene_of(facing_square(5.0f, 0.0f), behind);
    EXPECT_TRUE(seen(scene).radiance.unlit.empty());
    add(scene, facing_square(5.0f, 1.0f), layer({1.0f, 2.0f, 4.0f}, 0.25f, blend));
    const Result result = seen(scene);
    ASSERT_EQ(result.radiance.unlit.size(), result.radiance.values.size());
    double share = 0.0, light = 0.0;
    for (std::size_t i = 0; i < result.radiance.unlit.size(); i += 4) {
        share += static_cast<double>(result.radiance.unlit[i + 3]) / 256.0;
        light += static_cast<double>(result.radiance.unlit[i + 1]) / 256.0;
        EXPECT_FLOAT_EQ(result.radiance.unlit[i + 2], 4.0f * result.radiance.unlit[i + 3]);
    }
    EXPECT_NEAR(share, 0.25, 0.02);
    EXPECT_NEAR(light, 2.0 * share, 1e-5);
}

TEST(ReferenceLayers, CulledBacksAreSeenThrough)
{
    scene::Scene scene = scene_of(facing_square(5.0f, 0.0f), unlit({1.0f, 1.0f, 1.0f}));
    scene.instances[0].transform[0][0] = -1.0f; // mirrored: still seen from the side that its normals are on
    expect_light(seen(scene), glm::dvec3(1.0));
    scene.instances[0].transform[0][0] = 1.0f;
    scene.instances[0].transform[2][2] = -1.0f; // mirrored in its plane: now from behind
    EXPECT_EQ(coverage(seen(scene)), 0.0);
    scene.materials[0].double_sided = true;
    EXPECT_EQ(coverage(seen(scene)), 1.0);
}

} // namespace
} // namespace lambent::reference
