// Single pixels against whole pictures of the reference, and audits by it of scenes with a known truth.
#include "audit/audit.h"
#include "reference/pixel_tracer.h"
#include "scene/builtin/builtin.h"
#include "tests/reference/traced.h"

#include <gtest/gtest.h>

namespace lambent::audit {
namespace {

using reference::testing::panorama_of, reference::testing::small_settings, reference::testing::white_panorama;

TEST(PixelTracer, a_pixel_is_that_of_the_traced_picture)
{
    const scene::Scene scene = scene::make_builtin("sphere");
    const image::RadianceImage panorama =
        panorama_of(32, [](const glm::dvec3& d) { return glm::dvec3(1.0 + d.y, 1.0 + d.x, 1.0 + d.z); });
    reference::Settings settings = small_settings(12, 1.5f, 40);
    settings.camera.position.y = 0.5f;
    settings.seed = 9;
    settings.background.kind = view::Background::Kind::environment;
    const image::RadianceImage picture = reference::trace(scene, &panorama, settings).radiance;
    const reference::PixelTracer tracer(scene, &panorama, settings);
    double covered = 0.0;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
            const reference::PixelEstimate pixel = tracer.estimate({x, y, 40, 9});
            for (int c = 0; c < 3; ++c) // the picture adds floats
                EXPECT_NEAR(pixel.radiance[c], static_cast<double>(picture.pixel(x, y)[c]),
                            1e-5 * (1.0 + pixel.radiance[c]));
            EXPECT_NEAR(pixel.coverage, static_cast<double>(picture.pixel(x, y)[3]), 1e-6);
            EXPECT_EQ(pixel.broken, 0);
            covered += pixel.coverage;
        }
    EXPECT_GT(covered, 20.0);
    EXPECT_LT(covered, 124.0);
    EXPECT_NE(tracer.estimate({6, 6, 40, 9}).radiance, tracer.estimate({6, 6, 40, 10}).radiance);
    EXPECT_NE(tracer.estimate({6, 6, 40, 9}).radiance, tracer.estimate({6, 6, 39, 9}).radiance);
}

// A square of a known radiance fills the picture, which is drawn a tenth too bright.
TEST(Audit, an_unlit_square_drawn_too_bright)
{
    using namespace reference::testing;
    const scene::Scene scene = scene_of(facing_square(2.0f, 0.0f), unlit({0.25f, 0.5f, 0.75f}));
    const reference::Settings truth = small_settings(40, 2.0f, 1);
    image::RadianceImage picture = image::black_image(40, 40, 4);
    for (std::size_t i = 0; i < picture.values.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c)
            picture.values[i + c] = 1.1f * 0.25f * static_cast<float>(c + 1);
        picture.values[i + 3] = 1.0f;
    }
    const std::optional<Error> error = measure(scene, nullptr, truth, picture, {});
    ASSERT_TRUE(error);
    // Relative to the mean of all values: a tenth of the root of their mean square, over their mean.
    const double expected = 0.1 * std::sqrt((0.0625 + 0.25 + 0.5625) / 3.0) / 0.5;
    EXPECT_NEAR(error->relative_rmse, expected, 1e-6);
    EXPECT_NEAR(error->low, expected, 1e-6);
    EXPECT_NEAR(error->high, expected, 1e-6);
    Settings dark;
    dark.cut = 0.25; // all light is above
    EXPECT_NEAR(measure(scene, nullptr, truth, picture, dark)->relative_rmse, 0.0, 1e-6);
}

// A Lambertian square that faces a white world sends its colour, however noisy the paths: with the wrong colour it is
// wrong by as much, and with the right one the interval begins at 0 or close to it.
TEST(Audit, a_white_world_on_a_matt_square)
{
    using namespace reference::testing;
    const scene::Scene scene =
        scene_of(facing_square(2.0f, 0.0f), phong(glm::vec3(0.5f), glm::vec3(0.0f), 1.0f));
    reference::Settings truth = small_settings(40, 2.0f, 1);
    truth.model = view::Model::phong;
    truth.bounces = 1;
    const image::RadianceImage panorama = white_panorama();
    const auto drawn = [](float value) {
        image::RadianceImage picture{40, 40, 4, std::vector<float>(6400, value)};
        return picture;
    };
    const double light =
        reference::PixelTracer(scene, &panorama, truth).estimate({20, 20, 4096, 1}).radiance.x;
    const std::optional<Error> right = measure(scene, &panorama, truth, drawn(static_cast<float>(light)), {}),
                               wrong = measure(scene, &panorama, truth,
                                               drawn(static_cast<float>(1.2 * light)), {});
    ASSERT_TRUE(right && wrong);
    EXPECT_LT(right->low, 0.002);
    EXPECT_LT(right->high, 0.02);
    EXPECT_NEAR(wrong->relative_rmse, 0.2, 0.01);
    EXPECT_LE(wrong->low, 0.2);
    EXPECT_GE(wrong->high, 0.2);
}

} // namespace
} // namespace lambent::audit
