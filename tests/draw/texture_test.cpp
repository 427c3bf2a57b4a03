// Textures as surfaces show them: orientation, transfer, filtering, wrapping, normal maps.
#include "draw/textures/packed_texture.h"
#include "tests/draw/test_scenes.h"
#include "tests/draw/texcoord_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw {
namespace {

using testing::pixel;

image::CodeImage codes(int width, int height, const std::function<glm::ivec4(int, int)>& code)
{
    image::CodeImage image{width, height, 4, 8, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 4; ++c)
                image.bytes.push_back(static_cast<std::uint8_t>(code(x, y)[c]));
    return image;
}

scene::Scene textured(image::CodeImage image, scene::TextureUse use = {})
{
    scene::Scene scene;
    scene::Material material;
    material.unlit = true;
    use.image = 0;
    material.base_color_texture = use;
    testing::add(scene, testing::facing_square(0.5f, 0.0f), material);
    scene.images.push_back(std::move(image));
    return scene;
}

Settings view(int size)
{
    return testing::small_settings(size, size, testing::front_camera(1.0f));
}

glm::ivec4 quarters(int x, int y)
{
    return {x < 2 ? 255 : 0, y < 2 ? 255 : 0, 0, 255};
}

TEST(Textures, AreUprightAndNotMirrored)
{
    const Frame frame = testing::draw(textured(codes(4, 4, quarters)), nullptr, view(64));
    EXPECT_NEAR(pixel(frame, 10, 10).r, 1.0f, 1e-3f); // top left
    EXPECT_NEAR(pixel(frame, 10, 10).g, 1.0f, 1e-3f);
    EXPECT_NEAR(pixel(frame, 54, 10).r, 0.0f, 1e-3f); // top right
    EXPECT_NEAR(pixel(frame, 54, 10).g, 1.0f, 1e-3f);
    EXPECT_NEAR(pixel(frame, 10, 54).g, 0.0f, 1e-3f); // bottom left
}

TEST(Textures, CodesBecomeLightByTheChosenTransfer)
{
    const auto grey = [](int, int) { return glm::ivec4(128, 128, 128, 255); };
    Settings settings = view(8);
    const scene::Scene scene = textured(codes(4, 4, grey));
    // IEC 61966-2-1: code 128 is 0.21586 of white; 0.50196^2.2 = 0.21952.
    EXPECT_NEAR(pixel(testing::draw(scene, nullptr, settings), 4, 4).r, 0.21586f, 1e-4f);
    settings.texel_transfer = TexelTransfer::power_2_2;
    EXPECT_NEAR(pixel(testing::draw(scene, nullptr, settings), 4, 4).r, 0.21952f, 1e-4f);
    settings.texel_transfer = TexelTransfer::none;
    EXPECT_NEAR(pixel(testing::draw(scene, nullptr, settings), 4, 4).r, 0.50196f, 1e-4f);
}

// Which numbers the sets have is all the same, and each texture reads its own: the layers say what it found.
TEST(Textures, EachReadsItsOwnSetOfCoordinates)
{
    Settings settings = view(8);
    settings.layers = true;
    settings.samples = 8;
    const environment::Environment white = testing::white_environment();
    const Frame frame = testing::draw(testing::texcoord_scene({9, 4, 0, 1, 2}), &white, settings);
    // IEC 61966-2-1 of code 200 is 0.57758, of 60 0.04519; codes of roughness are linear.
    EXPECT_NEAR(testing::layer_pixel(frame, "base_color", 4, 4).r, 0.57758f, 1e-3f);
    EXPECT_NEAR(testing::layer_pixel(frame, "light_emitted", 4, 4).g, 0.04519f, 1e-4f);
    EXPECT_NEAR(testing::layer_pixel(frame, "roughness", 4, 4).g, 140.0f / 255.0f, 1e-3f);
    // (170, 150, 220) stands for (.333, .176, .725), which is made a unit long.
    EXPECT_NEAR(testing::layer_pixel(frame, "normal", 4, 4).x, 0.4080f, 2e-3f);
    const Frame others = testing::draw(testing::texcoord_scene({3, 2147483647, 8, 5, 7}), &white, settings);
    EXPECT_EQ(frame.radiance.values, others.radiance.values);
    // All from one set is another picture.
    EXPECT_NE(testing::draw(testing::texcoord_scene({1, 1, 1, 1, 1}), &white, settings).radiance.values,
              frame.radiance.values);
}

TEST(Textures, SixteenBitsAreKept)
{
    image::CodeImage image{2, 2, 4, 16, {}};
    for (int i = 0; i < 16; ++i) {
        const std::uint16_t code = 257 * 100 + 64; // a quarter of the way from one 8-bit code to the next
        image.bytes.push_back(static_cast<std::uint8_t>(code & 255));
        image.bytes.push_back(static_cast<std::uint8_t>(code >> 8));
    }
    Settings settings = view(8);
    settings.texel_transfer = TexelTransfer::none;
    const float expected = (257.0f * 100.0f + 64.0f) / 65535.0f;
    EXPECT_NEAR(pixel(testing::draw(textured(image), nullptr, settings), 4, 4).r, expected, 2e-4f);
}

// A checkerboard far finer than the pixels is the mean of its light, not of its codes.
TEST(Textures, MipMapsAverageLight)
{
    const auto checker = [](int x, int y) { return glm::ivec4(glm::ivec3((x + y) % 2 ? 255 : 0), 255); };
    const Frame frame = testing::draw(textured(codes(256, 256, checker)), nullptr, view(16));
    for (int y = 2; y < 14; ++y)
        for (int x = 2; x < 14; ++x)
            ASSERT_NEAR(pixel(frame, x, y).r, 0.5f, 0.01f);
}

TEST(Textures, OddSizesAverageEvenly)
{
    const auto ramp = [](int x, int) { return glm::ivec4(x == 1 ? 255 : 0, 0, 0, 255); };
    const PackedTexture texture = pack_texture(codes(3, 1, ramp), {}, TexelTransfer::none);
    ASSERT_EQ(texture.levels, 2);
    const std::uint8_t last = texture.bytes[4 * static_cast<std::size_t>(texture.start[1] + 3 + 1)];
    EXPECT_EQ(last, 85); // a third
}

// Colours average as light, alpha as it is: half of white is code 188 in sRGB, half of alpha 128.
TEST(Textures, MipMapsAverageAlphaAsItIs)
{
    const auto checker = [](int x, int y) { return glm::ivec4((x + y) % 2 ? 255 : 0); };
    for (const auto& [transfer, code] :
         {std::pair(TexelTransfer::srgb, 188), std::pair(TexelTransfer::power_2_2, 186),
          std::pair(TexelTransfer::none, 128)}) {
        const PackedTexture texture = pack_texture(codes(8, 8, checker), {}, transfer);
        const std::size_t at = 4 * static_cast<std::size_t>(texture.start[1] + (4 + 2) + 1);
        EXPECT_NEAR(texture.bytes[at], code, 1);
        EXPECT_NEAR(texture.bytes[at + 3], 128, 1);
    }
}

// A texel of the next level is the mean of what it covers: of an odd row, parts of three texels.
TEST(Textures, OddSizesAverageByArea)
{
    for (const int size : {3, 5, 7, 9, 15})
        for (int lit = 0; lit < size; ++lit) {
            const auto one = [=](int x, int y) {
                return glm::ivec4(x == lit ? 255 : 0, y == lit ? 255 : 0, 0, 255);
            };
            const PackedTexture texture = pack_texture(codes(size, size, one), {}, TexelTransfer::none);
            const int half = size / 2;
            ASSERT_EQ(texture.width[1], half);
            for (int i = 0; i < half; ++i) {
                // Texel i covers [i, i + 1] size / half texels of the finer level, of which `lit` is [lit, lit + 1].
                const double wide = static_cast<double>(size) / half;
                const double part =
                    std::min((i + 1) * wide, lit + 1.0) - std::max(i * wide, static_cast<double>(lit));
                const double wanted = 255.0 * std::max(part, 0.0) / wide;
                const auto code = [&](int x, int y, int channel) {
                    return texture.bytes[static_cast<std::size_t>(
                        4 * (texture.start[1] + (y + 1) * (half + 2) + x + 1) + channel)];
                };
                EXPECT_NEAR(code(i, half / 2, 0), wanted, 0.51) << size << ' ' << lit << ' ' << i;
                EXPECT_NEAR(code(half / 2, i, 1), wanted, 0.51) << size << ' ' << lit << ' ' << i;
            }
        }
}

// Seen at a flat angle a texture of stripes along the view keeps them; reading by the longer axis would blur them.
TEST(Textures, FlatAnglesStaySharpAcross)
{
    const auto stripes = [](int x, int) { return glm::ivec4(glm::ivec3(x / 8 % 2 ? 255 : 0), 255); };
    scene::Scene scene = textured(codes(64, 64, stripes));
    scene.instances[0].transform = glm::rotate(glm::mat4(1.0f), -1.40f, glm::vec3(1, 0, 0));
    const Frame frame = testing::draw(scene, nullptr, view(64));
    float least = 1.0f, most = 0.0f;
    for (int x = 8; x < 56; ++x) {
        least = std::min(least, pixel(frame, x, 32).r);
        most = std::max(most, pixel(frame, x, 32).r);
    }
    EXPECT_LT(least, 0.15f);
    EXPECT_GT(most, 0.85f);
}

TEST(Textures, WrapModesRepeatMirrorAndClamp)
{
    const auto halves = [](int x, int) { return glm::ivec4(x < 8 ? 255 : 0, 0, 0, 255); };
    scene::TextureUse use;
    use.transform[0][0] = 2.0f; // the texture twice across the square
    const auto at = [&](scene::Wrap wrap, int x) {
        use.sampler.wrap_u = wrap;
        return pixel(testing::draw(textured(codes(16, 16, halves), use), nullptr, view(64)), x, 32).r;
    };
    EXPECT_NEAR(at(scene::Wrap::repeat, 40), 1.0f, 0.01f);
    EXPECT_NEAR(at(scene::Wrap::repeat, 56), 0.0f, 0.01f);
    EXPECT_NEAR(at(scene::Wrap::mirrored_repeat, 40), 0.0f, 0.01f);
    EXPECT_NEAR(at(scene::Wrap::mirrored_repeat, 56), 1.0f, 0.01f);
    EXPECT_NEAR(at(scene::Wrap::clamp_to_edge, 56), 0.0f, 0.01f);
}

TEST(Textures, NearestShowsBlocks)
{
    const auto halves = [](int x, int) { return glm::ivec4(x == 0 ? 255 : 0, 0, 0, 255); };
    scene::TextureUse use;
    use.sampler.magnify_nearest = true;
    const Frame frame = testing::draw(textured(codes(2, 2, halves), use), nullptr, view(64));
    EXPECT_NEAR(pixel(frame, 30, 32).r, 1.0f, 1e-3f);
    EXPECT_NEAR(pixel(frame, 33, 32).r, 0.0f, 1e-3f);
}

TEST(Textures, TransparentTexelsAreCut)
{
    scene::Scene scene =
        textured(codes(4, 4, [](int x, int) { return glm::ivec4(255, 255, 255, x < 2 ? 255 : 0); }));
    scene.materials[0].alpha_mode = scene::AlphaMode::mask;
    const Frame frame = testing::draw(scene, nullptr, view(64));
    EXPECT_EQ(pixel(frame, 16, 32).a, 1.0f);
    EXPECT_EQ(pixel(frame, 48, 32).a, 0.0f);
}

// A map that turns all normals by 45 degrees to the right makes a mirror show what is on the right.
TEST(Textures, NormalMapsTurnNormals)
{
    const int tilted = static_cast<int>(std::lround((std::sqrt(0.5) * 0.5 + 0.5) * 255.0));
    scene::Scene scene;
    scene::Material mirror;
    mirror.metallic = 1.0f;
    mirror.perceptual_roughness = 0.05f;
    mirror.normal_texture.image = 0;
    testing::add(scene, testing::facing_square(0.5f, 0.0f), mirror);
    scene.images.push_back(codes(4, 4, [=](int, int) { return glm::ivec4(tilted, 128, tilted, 255); }));
    const environment::Environment right = testing::environment_of(
        256, [](glm::dvec3 d) { return d.x > 0.9 ? glm::vec3(1.0f) : glm::vec3(0.0f); });
    EXPECT_GT(pixel(testing::draw(scene, &right, view(8)), 4, 4).r, 0.9f);
    // Upwards: green.
    scene.images[0] = codes(4, 4, [=](int, int) { return glm::ivec4(128, tilted, tilted, 255); });
    const environment::Environment above = testing::environment_of(
        256, [](glm::dvec3 d) { return d.y > 0.9 ? glm::vec3(1.0f) : glm::vec3(0.0f); });
    EXPECT_GT(pixel(testing::draw(scene, &above, view(8)), 4, 4).r, 0.9f);
}

TEST(Textures, NormalMapsTurnNormalsAtEveryScale)
{
    for (float scale : {0.01f, 1.0f, 100.0f}) {
        scene::Scene scene;
        scene::Material material;
        material.normal_texture.image = 0;
        testing::add(scene, testing::facing_square(0.5f, 0.0f), material,
                     glm::scale(glm::mat4(1.0f), glm::vec3(scale)));
        scene.images.push_back(codes(4, 4, [](int, int) { return glm::ivec4(204, 128, 230, 255); }));
        Settings settings = testing::small_settings(8, 8, testing::front_camera(scale, 10.0f * scale));
        settings.layers = true;
        const Frame frame = testing::draw(scene, nullptr, settings);
        const glm::vec3 normal = testing::layer_pixel(frame, "normal", 4, 4);
        EXPECT_NEAR(normal.x, 0.6f, 0.01f) << scale;
        EXPECT_NEAR(normal.z, 0.8f, 0.01f) << scale;
    }
}

TEST(Textures, MetallicRoughnessAndOcclusionComeFromTheirChannels)
{
    scene::Scene scene;
    scene::Material material;
    material.metallic_roughness_texture.image = 0;
    material.occlusion_texture.image = 0;
    testing::add(scene, testing::facing_square(0.5f, 0.0f), material);
    scene.images.push_back(codes(4, 4, [](int, int) { return glm::ivec4(51, 102, 204, 255); }));
    Settings settings = view(8);
    settings.layers = true;
    const Frame frame = testing::draw(scene, nullptr, settings);
    EXPECT_NEAR(testing::layer_pixel(frame, "occlusion", 4, 4).r, 0.2f, 1e-3f);
    EXPECT_NEAR(testing::layer_pixel(frame, "alpha", 4, 4).r, 0.4f * 0.4f, 1e-3f);
    EXPECT_NEAR(testing::layer_pixel(frame, "metalness", 4, 4).r, 0.8f, 1e-3f);
}

} // namespace
} // namespace lambent::draw
