// Masks on a device cover what they do on the processor.
#include "draw/vulkan/vulkan_renderer.h"
#include "tests/draw/mask_scenes.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

namespace lambent::draw {
namespace {

using namespace testing;

class MaskParity : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (!test::Compute::open()) {
            ASSERT_FALSE(test::vulkan_required()) << "no Vulkan device";
            GTEST_SKIP() << "no Vulkan device";
        }
    }
};

double coverage(Renderer& renderer, int size)
{
    return mean_of(renderer.draw(nullptr, mask_view(size)), 3);
}

TEST_F(MaskParity, KeepTheirShareAtEverySize)
{
    for (const float cutoff : {0.2f, 0.5f, 0.8f}) {
        const scene::Scene four = mask_scene(squares_of_four(), mask_material(cutoff)),
                           thin = mask_scene(thin_posts(), mask_material(cutoff));
        const auto squares = make_vulkan_renderer(four), posts = make_vulkan_renderer(thin);
        for (const int size : mask_sizes) {
            EXPECT_NEAR(coverage(*squares, size), share_of_squares(static_cast<double>(cutoff)), 0.01)
                << cutoff << ' ' << size;
            EXPECT_NEAR(coverage(*posts, size), share_of_posts(static_cast<double>(cutoff)), 0.01)
                << cutoff << ' ' << size;
        }
    }
}

TEST_F(MaskParity, FactorsCountBeforeTheCutoff)
{
    scene::Material material = mask_material(0.24f);
    material.base_color.a = 0.8f;
    scene::Scene scene = mask_scene(squares_of_four(), material);
    scene.meshes[0].colors.assign(4, {1.0f, 1.0f, 1.0f, 0.5f});
    const auto renderer = make_vulkan_renderer(scene);
    for (const int size : mask_sizes)
        EXPECT_NEAR(coverage(*renderer, size), share_of_squares(0.6), 0.01) << size;
    scene.materials[0].alpha_cutoff = 0.41f;
    EXPECT_EQ(coverage(*make_vulkan_renderer(scene), 41), 0.0);
    scene.materials[0].base_color_texture.image = -1; // vertices and factor alone
    EXPECT_EQ(coverage(*make_vulkan_renderer(scene), 41), 0.0);
    scene.materials[0].alpha_cutoff = 0.39f;
    EXPECT_EQ(coverage(*make_vulkan_renderer(scene), 41), 1.0);
}

} // namespace
} // namespace lambent::draw
