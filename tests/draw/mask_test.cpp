// Masks cover the same share of a picture at every size.
#include "draw/textures/mask_coverage.h"
#include "tests/draw/mask_scenes.h"

#include <gtest/gtest.h>

#include <random>

namespace lambent::draw {
namespace {

using namespace testing;

double coverage(const scene::Scene& scene, int size)
{
    return mean_of(draw(scene, nullptr, mask_view(size)), 3);
}

void expect_share_at_every_size(const scene::Scene& scene, double share)
{
    for (const int size : mask_sizes)
        EXPECT_NEAR(coverage(scene, size), share, 0.01) << size;
}

// A single opaque texel: a tent on either axis, whose part above 1/2 and above 4/5 lies within it.
TEST(MaskCoverage, IsTheAreaAboveTheCutoff)
{
    AlphaAround around{};
    around.alpha[1][1] = 1.0f;
    for (const double least : {0.5, 0.8})
        EXPECT_NEAR(covered_share(around, static_cast<float>(least), false),
                    4.0 * (1.0 - least + least * std::log(least)), 0.01)
            << least;
    EXPECT_EQ(covered_share(around, 0.2f, false), 1.0f);
    EXPECT_EQ(covered_share(around, 0.8f, true), 1.0f);
    EXPECT_EQ(covered_share(around, 1.1f, false), 0.0f);
    for (auto& row : around.alpha) // rises to the right: 0, 1/2, 1
        row[0] = 0.0f, row[1] = 0.5f, row[2] = 1.0f;
    EXPECT_FLOAT_EQ(covered_share(around, 0.6f, false), 0.3f);
    EXPECT_EQ(covered_share(around, 0.6f, true), 0.0f);
}

TEST(Masks, SquaresKeepTheirShare)
{
    for (const float cutoff : {0.2f, 0.5f, 0.8f}) {
        SCOPED_TRACE(cutoff);
        const double share = share_of_squares(static_cast<double>(cutoff));
        expect_share_at_every_size(mask_scene(squares_of_four(), mask_material(cutoff)), share);
    }
}

TEST(Masks, ThinPostsKeepTheirShare)
{
    for (const float cutoff : {0.2f, 0.5f, 0.8f}) {
        SCOPED_TRACE(cutoff);
        expect_share_at_every_size(mask_scene(thin_posts(), mask_material(cutoff)),
                                   share_of_posts(static_cast<double>(cutoff)));
    }
}

// The factor, and the alpha of vertices, move the cutoff.
TEST(Masks, FactorsCountBeforeTheCutoff)
{
    scene::Material material = mask_material(0.24f);
    material.base_color.a = 0.8f;
    scene::Scene scene = mask_scene(squares_of_four(), material);
    expect_share_at_every_size(scene, share_of_squares(0.3));
    scene.meshes[0].colors.assign(4, {1.0f, 1.0f, 1.0f, 0.5f});
    expect_share_at_every_size(scene, share_of_squares(0.6));
    scene.materials[0].alpha_cutoff = 0.41f; // more than what is left of 1
    expect_share_at_every_size(scene, 0.0);
}

// Vertices that fade away: the half that cannot reach the cutoff is not there at any size.
TEST(Masks, VerticesBelowTheCutoffAreNotThere)
{
    scene::Scene scene = mask_scene(mask_image(64, [](int, int) { return 255; }), mask_material(0.5f));
    scene.meshes[0].colors = {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0}};
    for (const int size : {500, 100, 20}) {
        const Frame frame = draw(scene, nullptr, mask_view(size));
        EXPECT_NEAR(mean_of(frame, 3), 0.5, 1e-6) << size;
        EXPECT_EQ(pixel(frame, size / 2 - 1, size / 2).a, 0.0f);
        EXPECT_EQ(pixel(frame, size / 2, size / 2).a, 1.0f);
    }
}

TEST(Masks, CutoffsBeyondTheRangeShowAllOrNothing)
{
    expect_share_at_every_size(mask_scene(squares_of_four(), mask_material(0.0f)), 1.0);
    expect_share_at_every_size(mask_scene(squares_of_four(), mask_material(1.5f)), 0.0);
}

// One image, of random alpha in blocks, with three cutoffs: as many texels as there are.
TEST(Masks, MaterialsShareAnImageWithCutoffsOfTheirOwn)
{
    std::mt19937 random(7);
    std::vector<int> alphas;
    const image::CodeImage codes = mask_image(128, [&](int, int) {
        alphas.push_back(static_cast<int>(random() % 256));
        return alphas.back();
    });
    scene::Scene scene;
    scene.images.push_back(codes);
    const float cutoffs[] = {0.2f, 0.5f, 0.8f};
    for (int i = 0; i < 3; ++i) {
        scene::Material material = mask_material(cutoffs[i]);
        material.base_color_texture.sampler.magnify_nearest = true;
        const float x = 2.0f * static_cast<float>(i - 1);
        add(scene, facing_square(1.0f, 0.0f), material,
            glm::translate(glm::mat4(1.0f), glm::vec3(x, 0.0f, 0.0f)));
    }
    for (int i = 0; i < 3; ++i) {
        const double least = 255.0 * static_cast<double>(cutoffs[i]);
        const auto count = std::count_if(alphas.begin(), alphas.end(), [&](int a) { return a >= least; });
        for (const int size : {331, 50, 16, 8}) {
            Settings settings = mask_view(size);
            settings.camera.position.x = 2.0f * static_cast<float>(i - 1);
            EXPECT_NEAR(mean_of(draw(scene, nullptr, settings), 3),
                        static_cast<double>(count) / static_cast<double>(alphas.size()), 0.012)
                << i << ' ' << size;
        }
    }
}

// Large, each pixel is there or not; small, what is there has its own colour, not that of what is cut away.
TEST(Masks, AreHardWhenLargeAndKeepTheirColourWhenSmall)
{
    const scene::Scene scene = mask_scene(squares_of_four(), mask_material(0.5f));
    const Frame large = draw(scene, nullptr, mask_view(600));
    for (int y = 0; y < 600; ++y)
        for (int x = 0; x < 600; ++x) {
            const float alpha = pixel(large, x, y).a;
            ASSERT_TRUE(alpha == 0.0f || alpha == 1.0f) << x << ' ' << y;
        }
    for (const int size : {24, 16, 8}) {
        const Frame small = draw(scene, nullptr, mask_view(size));
        EXPECT_NEAR(mean_of(small, 0) / mean_of(small, 3), 1.0, 0.01) << size;
    }
}

// A tilted square is magnified along one axis and not along the other.
TEST(Masks, KeepTheirShareWhenTilted)
{
    scene::Scene scene = mask_scene(squares_of_four(), mask_material(0.5f));
    scene.instances[0].transform = glm::rotate(glm::mat4(1.0f), 1.4f, glm::vec3(1.0f, 0.0f, 0.0f));
    const double share = share_of_squares(0.5) * std::cos(1.4);
    for (const int size : {400, 256, 128, 64, 32})
        EXPECT_NEAR(coverage(scene, size), share, 0.05 * share) << size;
}

// Behind so many leaves as cover less than all something is seen: what they leave.
TEST(Masks, LayersMultiply)
{
    scene::Scene scene = mask_scene(squares_of_four(), mask_material(0.5f));
    scene.instances.push_back(scene.instances[0]);
    scene.instances[1].transform[3] = {0.013f, 0.029f, -0.5f, 1.0f};
    const double left = 1.0 - share_of_squares(0.5);
    EXPECT_NEAR(coverage(scene, 8), 1.0 - left * left, 0.02);
}

} // namespace
} // namespace lambent::draw
