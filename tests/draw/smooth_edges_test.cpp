// Rims of smooth curved surfaces: a mirroring ball held against quadrature over each pixel, and what decides how many points of
// a pixel are lit.
#include "draw/textures/typical_alpha.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lambent::draw {
namespace {

using glm::dvec3;
using testing::add, testing::environment_of, testing::front_camera, testing::pixel, testing::small_settings;

// A dim room with eight bright discs of 8 degrees behind the ball: all of them are mirrored near its rim.
double room(const dvec3& d)
{
    constexpr double degree = std::numbers::pi / 180.0;
    for (int i = 0; i < 8; ++i) {
        const double turn = (45.0 * i + 10.0) * degree, away = (125.0 + 6.0 * i) * degree;
        const dvec3 lamp(std::sin(away) * std::cos(turn), std::sin(away) * std::sin(turn), std::cos(away));
        if (glm::dot(d, lamp) > std::cos(8.0 * degree))
            return 3.0;
    }
    return 0.2;
}

constexpr int side = 33;
constexpr double radius = 0.5, step = 1.1 / side; // metres; of a pixel

// The mean over a pixel of what a perfect mirror shows, black beside it, and its coverage.
struct Truth {
    double light = 0.0, coverage = 0.0;
};

Truth truth_at(int column, int row)
{
    constexpr int fine = 48;
    Truth sum;
    for (int i = 0; i < fine * fine; ++i) {
        const int across = i % fine, down = i / fine;
        const double x = (column + (across + 0.5) / fine - 0.5 * side) * step / radius,
                     y = (0.5 * side - row - (down + 0.5) / fine) * step / radius;
        if (x * x + y * y >= 1.0)
            continue;
        const dvec3 normal(x, y, std::sqrt(1.0 - x * x - y * y));
        sum.light += room(2.0 * normal.z * normal - dvec3(0.0, 0.0, 1.0)) / (fine * fine);
        sum.coverage += 1.0 / (fine * fine);
    }
    return sum;
}

// Relative RMSE of light cut at 1, over the pixels that the ball covers.
double rim_error(const Settings& settings)
{
    scene::Scene scene;
    scene::Material mirror;
    mirror.base_color = glm::vec4(1.0f);
    mirror.metallic = 1.0f;
    mirror.perceptual_roughness = 0.02f;
    add(scene, scene::make_sphere(static_cast<float>(radius), 512, 256), mirror);
    static const environment::Environment environment =
        environment_of(1024, [](dvec3 d) { return glm::vec3(static_cast<float>(room(d))); });
    const Frame frame = testing::draw(scene, &environment, settings);
    double squares = 0.0, light = 0.0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const Truth truth = truth_at(column, row);
            if (truth.coverage <= 0.0)
                continue;
            const double wanted = std::min(truth.light, 1.0);
            const double seen = std::min(static_cast<double>(pixel(frame, column, row).r), 1.0);
            squares += (seen - wanted) * (seen - wanted);
            light += wanted;
        }
    constexpr double count = std::numbers::pi * radius * radius / (step * step); // all but those at the rim
    return std::sqrt(squares / count) / (light / count);
}

TEST(SmoothEdges, ARimMirrorsWhatQuadratureSays)
{
    Settings settings = small_settings(side, side, front_camera(1.1f));
    const double usual = rim_error(settings);
    settings.edge_samples = 4;
    const double few = rim_error(settings);
    settings.edge_samples = 64;
    const double many = rim_error(settings);
    std::printf("4, %d and 64 samples at edges: %.4f, %.4f, %.4f\n", Settings().edge_samples, few, usual,
                many);
    EXPECT_LT(usual, 0.1);
    EXPECT_LT(usual, 0.5 * few);
    EXPECT_LT(many, usual);
}

TEST(SmoothEdges, AMaterialIsAsSmoothAsItsNarrowestLobe)
{
    scene::Material material;
    material.perceptual_roughness = 0.6f;
    const Settings ggx;
    Settings phong;
    phong.model = Model::phong;
    EXPECT_NEAR(TypicalAlpha(material, {}).in(ggx), 0.36f, 1e-6f);
    EXPECT_NEAR(TypicalAlpha(material, {}).in(phong), 0.36f, 1e-6f);
    material.coat = 0.5f;
    material.coat_roughness = 0.2f;
    EXPECT_NEAR(TypicalAlpha(material, {}).in(ggx), 0.04f, 1e-6f);
    material.coat = 0.0f;
    EXPECT_NEAR(TypicalAlpha(material, {}).in(ggx), 0.36f, 1e-6f);
    material.phong.exponent = 198.0f;
    EXPECT_NEAR(TypicalAlpha(material, {}).in(phong), 0.1f, 1e-6f); // alpha^2 = 2 / (n + 2)
    Settings set = ggx;
    set.roughness_override = 0.3f;
    EXPECT_NEAR(TypicalAlpha(material, {}).in(set), 0.09f, 1e-6f);
}

// Codes 0 and 255 in a chequerboard of G, whatever the filter and the number of bits.
TEST(SmoothEdges, ARoughnessTextureCountsByItsMean)
{
    for (const bool mipmapped : {true, false})
        for (const int bits : {8, 16}) {
            image::CodeImage image{128, 64, 4, bits, {}};
            for (int i = 0; i < 128 * 64; ++i)
                for (const int code : {7, (i + i / 128) % 2 * 255, 9, 255})
                    image.bytes.insert(image.bytes.end(), static_cast<std::size_t>(bits / 8),
                                       static_cast<std::uint8_t>(code));
            scene::Sampler sampler;
            sampler.mipmapped = mipmapped;
            const PackedTexture texture = pack_texture(image, sampler, TexelTransfer::none);
            EXPECT_NEAR(mean_texel(&texture).r, 7.0f / 255.0f, 2e-3f);
            EXPECT_NEAR(mean_texel(&texture).g, 0.5f, 5e-3f);
            MaterialTextures textures{};
            textures[static_cast<std::size_t>(scene::texture_metallic_roughness)] = &texture;
            scene::Material material;
            material.perceptual_roughness = 0.8f;
            EXPECT_NEAR(TypicalAlpha(material, textures).ggx, std::pow(0.8f * mean_texel(&texture).g, 2.0f),
                        1e-6f);
        }
    EXPECT_EQ(mean_texel(nullptr), glm::vec4(1.0f));
}

} // namespace
} // namespace lambent::draw
