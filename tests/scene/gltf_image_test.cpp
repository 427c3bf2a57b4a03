// Pictures in bufferViews, data URIs and files.
#include "image/files/image_io.h"
#include "scene/gltf/gltf.h"
#include "tests/scene/gltf_builder.h"
#include "tests/scene/png_writer.h"

#include "base/file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include <unistd.h>

namespace lambent::scene::test {
namespace {

namespace fs = std::filesystem;

// A drawn triangle whose base colour is the given image.
GltfBuilder textured(const std::function<json(GltfBuilder&)>& make_image)
{
    GltfBuilder builder = triangle();
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = builder.add_vec2({0, 0, 1, 0, 0, 1});
    primitive["material"] = 0;
    builder.document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    builder.document["textures"] = {{{"source", 0}}};
    builder.add_to("images", make_image(builder));
    return builder;
}

const Pixels two_pixels = {2, 1, 8, {10, 20, 30, 40, 50, 60, 70, 80}};

TEST(GltfImage, BufferViewAndDataUriHoldTheSame)
{
    const Bytes png = make_png(two_pixels);
    const auto in_view = textured([&](GltfBuilder& b) {
        return json{{"bufferView", b.add_view(png)}, {"mimeType", "image/png"}};
    });
    const auto in_uri = textured([&](GltfBuilder&) {
        return json{{"uri", "data:image/png;base64," + base64(png)}};
    });
    for (const GltfBuilder& builder : {in_view, in_uri}) {
        const Scene scene = load(builder);
        ASSERT_EQ(scene.images.size(), 1u);
        const image::CodeImage& image = scene.images[0];
        EXPECT_EQ(image.width, 2);
        EXPECT_EQ(image.height, 1);
        EXPECT_EQ(image.channels, 4);
        EXPECT_EQ(image.bits, 8);
        EXPECT_EQ(image.bytes, (Bytes{10, 20, 30, 40, 50, 60, 70, 80}));
    }
}

TEST(GltfImage, SixteenBitsAreKept)
{
    const Scene scene = load(textured([](GltfBuilder& b) {
        return json{{"bufferView", b.add_view(make_png({1, 1, 16, {0x1234, 0xABCD, 0, 0xFFFF}}))}};
    }));
    EXPECT_EQ(scene.images.at(0).bits, 16);
    std::uint16_t codes[4];
    ASSERT_EQ(scene.images[0].bytes.size(), sizeof codes);
    std::memcpy(codes, scene.images[0].bytes.data(), sizeof codes);
    EXPECT_EQ(codes[0], 0x1234);
    EXPECT_EQ(codes[1], 0xABCD);
}

TEST(GltfImage, FilesBesideTheGltfAreFoundPngAndJpeg)
{
    const fs::path folder = fs::temp_directory_path() / ("lambent_gltf_image_" + std::to_string(::getpid()));
    fs::create_directories(folder / "maps");
    write_file(folder / "maps" / "base color.png", make_png(two_pixels));
    write_file(folder / "png.gltf", textured([](GltfBuilder&) {
                                        return json{{"uri", "maps/base%20color.png"}};
                                    }).gltf());
    image::CodeImage grey{8, 8, 3, 8, Bytes(8 * 8 * 3, 128)};
    image::write_codes(grey, folder / "grey.jpg");
    write_file(folder / "jpeg.gltf", textured([](GltfBuilder&) { return json{{"uri", "grey.jpg"}}; }).gltf());
    write_file(folder / "missing.gltf", textured([](GltfBuilder&) {
                                            return json{{"uri", "no.png"}};
                                        }).gltf());

    Warnings warnings;
    EXPECT_EQ(load_gltf(folder / "png.gltf", warnings).images.at(0).bytes[5], 60);
    const image::CodeImage jpeg = load_gltf(folder / "jpeg.gltf", warnings).images.at(0);
    EXPECT_EQ(jpeg.width, 8);
    EXPECT_NEAR(jpeg.bytes[0], 128, 1);
    EXPECT_EQ(jpeg.bytes[3], 255);
    EXPECT_TRUE(warnings.empty());
    EXPECT_TRUE(load_gltf(folder / "missing.gltf", warnings).images.empty());
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(contains(warnings[0], "missing.gltf: image 0: ")) << warnings[0];
    EXPECT_TRUE(contains(warnings[0], "no.png: No such file")) << warnings[0];
    fs::remove_all(folder);
}

TEST(GltfImage, OnlyImagesOfDrawnPrimitivesAreDecoded)
{
    GltfBuilder builder = textured([](GltfBuilder& b) {
        return json{{"bufferView", b.add_view(make_png(two_pixels))}};
    });
    builder.add_to("images", {{"uri", "not-there.png"}});
    builder.add_to("images", {{"bufferView", 0}}); // the positions: no picture
    builder.add_to("textures", {{"source", 1}});
    builder.add_to("materials", {{"emissiveTexture", {{"index", 1}}}});
    EXPECT_EQ(load(builder).images.size(), 1u);
}

TEST(GltfImage, TheSameBytesAreDecodedOnce)
{
    GltfBuilder builder = textured([](GltfBuilder& b) {
        return json{{"bufferView", b.add_view(make_png(two_pixels))}};
    });
    builder.add_to("images", builder.document["images"][0]);
    builder.add_to("textures", {{"source", 1}});
    builder.document["materials"][0]["emissiveTexture"] = {{"index", 1}};
    const Scene scene = load(builder);
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.materials[0].emissive_texture.image, 0);
    EXPECT_EQ(scene.materials[0].base_color_texture.image, 0);
}

TEST(GltfImage, BrokenPicturesAreNamedAndLeftOut)
{
    const auto complaint_of = [](const GltfBuilder& builder) {
        const Scene scene = load(builder);
        EXPECT_EQ(scene.instances.size(), 1u);
        EXPECT_TRUE(scene.images.empty());
        EXPECT_EQ(scene.materials.at(0).base_color_texture.image, -1);
        return complaint(builder);
    };
    const GltfBuilder no_picture = textured([](GltfBuilder& b) {
        return json{{"name", "wood"}, {"bufferView", b.add_view(to_bytes("RIFFxxxxWEBP"))}};
    });
    EXPECT_EQ(complaint_of(no_picture),
              "test.gltf: image 0 (wood): neither PNG nor JPEG: the texture is left out");
    Bytes cut = make_png(two_pixels);
    cut.resize(cut.size() - 30); // into the pixels
    const GltfBuilder truncated = textured([&](GltfBuilder& b) {
        return json{{"name", "wood"}, {"bufferView", b.add_view(cut)}};
    });
    EXPECT_TRUE(contains(complaint_of(truncated), "test.gltf: image 0 (wood): not a valid PNG: "));
    const GltfBuilder empty = textured([](GltfBuilder&) { return json{{"uri", "data:image/png;base64,"}}; });
    EXPECT_EQ(complaint_of(empty), "test.gltf: image 0: neither PNG nor JPEG: the texture is left out");
    const GltfBuilder no_base64 = textured([](GltfBuilder&) { return json{{"uri", "data:,x"}}; });
    EXPECT_EQ(complaint_of(no_base64),
              "test.gltf: image 0: a data URI must be base64: the texture is left out");
    const GltfBuilder no_object = textured([](GltfBuilder&) { return json(7); });
    EXPECT_EQ(complaint_of(no_object), "test.gltf: image 0: not an object: left out");
    const GltfBuilder outside = textured([](GltfBuilder&) { return json{{"uri", "../a.png"}}; });
    EXPECT_EQ(complaint_of(outside), "test.gltf: image 0: \"../a.png\" is an external file; only embedded "
                                     "data is read: the texture is left out");
}

TEST(GltfImage, OtherImagesKeepTheirPlacesWhenOneIsLeftOut)
{
    GltfBuilder builder = textured([](GltfBuilder& b) {
        return json{{"bufferView", b.add_view(to_bytes("no picture"))}};
    });
    builder.add_to("images", {{"bufferView", builder.add_view(make_png(two_pixels))}});
    builder.add_to("textures", {{"source", 1}});
    builder.document["materials"][0]["emissiveTexture"] = {{"index", 1}};
    builder.document["materials"][0]["normalTexture"] = {{"index", 0}};
    const Scene scene = load(builder);
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].bytes[0], 10);
    EXPECT_EQ(scene.materials[0].emissive_texture.image, 0);
    EXPECT_EQ(scene.materials[0].base_color_texture.image, -1);
    EXPECT_EQ(scene.materials[0].normal_texture.image, -1);
}

TEST(GltfImage, ADamagedPictureIsShownWithAWarning)
{
    Bytes open = make_png(two_pixels);
    open.resize(open.size() - 12); // without its end mark
    const GltfBuilder builder = textured([&](GltfBuilder& b) {
        return json{{"bufferView", b.add_view(open)}};
    });
    EXPECT_EQ(load(builder).images.at(0).bytes, (Bytes{10, 20, 30, 40, 50, 60, 70, 80}));
    EXPECT_TRUE(contains(complaint(builder), "test.gltf: image 0: not a valid PNG: ")) << complaint(builder);
}

TEST(GltfImage, MorePixelsThanReasonableAreLeftOutBeforeTheyAreDecoded)
{
    // Five headers of 16384 x 16384 pixels, without any data behind them: the fifth is one too many.
    GltfBuilder builder = textured([](GltfBuilder&) { return json::object(); });
    builder.document["images"] = json::array();
    builder.document["textures"] = json::array();
    for (int i = 0; i < 5; ++i) {
        builder.add_to("images", {{"bufferView", builder.add_view(make_png({16384, 16384, 8, {}}))}});
        builder.add_to("textures", {{"source", i}});
    }
    json& material = builder.document["materials"][0];
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 1}};
    material["normalTexture"] = {{"index", 2}};
    material["occlusionTexture"] = {{"index", 3}};
    material["emissiveTexture"] = {{"index", 4}};
    Warnings warnings;
    EXPECT_TRUE(load(builder, &warnings).images.empty());
    EXPECT_TRUE(warned_once(
        warnings, "image 4: 268435456 pixels, together with the images before it more than 1073741824: "
                  "the texture is left out"));
    EXPECT_TRUE(warned_once(warnings, "image 0: a file of ")) << "cannot hold its pixels";
    EXPECT_EQ(warnings.size(), 2u) << "the first four in one line";
}

} // namespace
} // namespace lambent::scene::test
