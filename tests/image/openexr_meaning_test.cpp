// What the attributes of OpenEXR files say of their pixels: windows, colours, directions.
#include "image/files/image_io.h"
#include "image/openexr/openexr.h"
#include "tests/image/exr_files.h"

#include <ImfEnvmap.h>
#include <ImfRgbaFile.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lambent::image {
namespace {

using namespace lambent::test;
using Bytes = std::vector<std::uint8_t>;

Warnings warnings_of(const Bytes& bytes)
{
    return open_exr(open_bytes(bytes, "test.exr"))->warnings();
}

Imath::Box2i box(int x, int y, int width, int height)
{
    return {{x, y}, {x + width - 1, y + height - 1}};
}

// Each pixel of the display window: that of the data window, or black.
void expect_windows(const Imath::Box2i& data, const Imath::Box2i& display, int tile)
{
    ExrRecipe recipe;
    recipe.width = data.max.x - data.min.x + 1;
    recipe.height = data.max.y - data.min.y + 1;
    recipe.min_x = data.min.x;
    recipe.min_y = data.min.y;
    recipe.display = display;
    recipe.tile = tile;
    recipe.value = [](int x, int y, std::size_t channel) { return 1.0f + exr_value(x, y, channel); };
    const Bytes bytes = make_exr(recipe);
    for (const int portion : {1, 7, 1000}) {
        const RadianceImage image = read_exr(bytes, portion);
        ASSERT_EQ(image.width, display.max.x - display.min.x + 1);
        ASSERT_EQ(image.height, display.max.y - display.min.y + 1);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (std::size_t c = 0; c < 3; ++c) {
                    const Imath::V2i at(x + display.min.x, y + display.min.y);
                    const float expected = data.intersects(at)
                                               ? 1.0f + exr_value(at.x - data.min.x, at.y - data.min.y, c)
                                               : 0.0f;
                    ASSERT_EQ(image.pixel(x, y)[c], expected) << x << "," << y << "," << c;
                }
    }
    const ImageInfo info = inspect_exr(*open_bytes(bytes, "test.exr"));
    EXPECT_EQ(info.width, display.max.x - display.min.x + 1);
    EXPECT_EQ(info.height, display.max.y - display.min.y + 1);
}

TEST(OpenExrMeaning, the_display_window_is_the_image)
{
    for (const int tile : {0, 16}) {
        expect_windows(box(8, 4, 16, 8), box(0, 0, 32, 16), tile);      // a part was drawn
        expect_windows(box(-5, -3, 42, 122), box(0, 0, 32, 116), tile); // more was drawn
        expect_windows(box(-10, 90, 32, 90), box(0, 0, 20, 100), tile); // some of both
        expect_windows(box(-7, 1000, 20, 50), box(-7, 1000, 20, 50), tile);
        expect_windows(box(-100, -200, 20, 30), box(-90, -190, 40, 50), tile);
        expect_windows(box(19, 0, 5, 5), box(0, 4, 20, 2), tile); // one pixel
    }
    const ImageInfo info = inspect_exr(*open_bytes(
        make_exr({.width = 16, .height = 8, .min_x = 8, .min_y = 4, .display = box(0, 0, 32, 16)}), "x"));
    EXPECT_EQ(info.detail, "32-bit float B G R, ZIP, of which 16x8 at 8,4 are stored");
}

TEST(OpenExrMeaning, colours_are_brought_to_rec_709)
{
    ExrRecipe recipe;
    recipe.value = [](int, int, std::size_t channel) {
        constexpr float rec2020[3] = {0.4f, 0.3f, 0.2f};
        return rec2020[channel];
    };
    recipe.attributes = [](Imf::Header& header) {
        Imf::addChromaticities(header,
                               {{0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.3290f}});
    };
    // [ITU-R BT.2087-0, M2] by hand.
    const float expected[3] = {1.6605f * 0.4f - 0.5876f * 0.3f - 0.0728f * 0.2f,
                               -0.1246f * 0.4f + 1.1329f * 0.3f - 0.0083f * 0.2f,
                               -0.0182f * 0.4f - 0.1006f * 0.3f + 1.1187f * 0.2f};
    const Bytes bytes = make_exr(recipe);
    const RadianceImage image = read_exr(bytes);
    for (std::size_t i = 0; i < image.values.size(); ++i)
        ASSERT_NEAR(image.values[i], expected[i % 3], 1e-4f);
    EXPECT_TRUE(warnings_of(bytes).empty());
    EXPECT_NE(inspect_exr(*open_bytes(bytes, "x")).detail.find("other primaries"), std::string::npos);
}

TEST(OpenExrMeaning, tristimulus_values_are_not_adapted)
{
    ExrRecipe recipe;
    recipe.value = [](int, int, std::size_t channel) {
        constexpr float xyz[3] = {0.95047f, 1.0f, 1.08883f}; // D65
        return 2.0f * xyz[channel];
    };
    recipe.attributes = [](Imf::Header& header) {
        Imf::addChromaticities(header, {{1, 0}, {0, 1}, {0, 0}, {1.0f / 3, 1.0f / 3}});
    };
    for (const float value : read_exr(make_exr(recipe)).values)
        ASSERT_NEAR(value, 2.0f, 2e-3f);
}

TEST(OpenExrMeaning, chromaticities_without_sense_are_warned_of)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Imf::Chromaticities& odd :
         {Imf::Chromaticities({0.3f, 0.3f}, {0.4f, 0.4f}, {0.5f, 0.5f}), Imf::Chromaticities({nan, 0.3f})}) {
        ExrRecipe recipe;
        recipe.attributes = [&](Imf::Header& header) { Imf::addChromaticities(header, odd); };
        const Bytes bytes = make_exr(recipe);
        EXPECT_EQ(read_exr(bytes).values, read_exr(make_exr({})).values);
        const Warnings warnings = warnings_of(bytes);
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_EQ(warnings[0], "test.exr: its attribute chromaticities is invalid; it is ignored");
    }
}

// As the library writes it; the picture is smooth, for of the colours it keeps a quarter of the pixels.
TEST(OpenExrMeaning, luminance_and_chroma)
{
    constexpr int width = 40, height = 24;
    const auto light = [](int x, int y, int c) {
        return 0.5f + 0.01f * static_cast<float>(x) + (c == 0 ? 0.02f : 0.005f) * static_cast<float>(y) +
               (c == 2 ? 0.3f : 0.0f);
    };
    const Imf::Chromaticities rec2020({0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f});
    for (const bool wide : {false, true}) {
        const TemporaryFolder folder;
        const std::string path = (folder / "yc.exr").string();
        {
            Imf::Header header(box(0, 0, width + 4, height), box(-2, 4, width, height));
            if (wide)
                Imf::addChromaticities(header, rec2020);
            std::vector<Imf::Rgba> pixels;
            for (int i = 0; i < width * height; ++i)
                pixels.emplace_back(light(i % width, i / width, 0), light(i % width, i / width, 1),
                                    light(i % width, i / width, 2));
            Imf::RgbaOutputFile file(path.c_str(), header, Imf::WRITE_YC);
            file.setFrameBuffer(pixels.data() - (-2 + 4 * width), 1, width);
            file.writePixels(height);
        }
        const Bytes bytes = content_of(path);
        for (const int portion : {5, 1000}) {
            const RadianceImage image = read_exr(bytes, portion);
            ASSERT_EQ(image.width, width + 4);
            for (int y = 6; y < height - 6; ++y)
                for (int x = 6; x < width - 6; ++x)
                    for (int c = 0; c < 3; ++c) {
                        constexpr float m[3][3] = {{1.6605f, -0.5876f, -0.0728f},
                                                   {-0.1246f, 1.1329f, -0.0083f},
                                                   {-0.0182f, -0.1006f, 1.1187f}};
                        const int from_x = x + 2, from_y = y - 4;
                        float expected = light(from_x, from_y, c);
                        if (wide)
                            expected = m[c][0] * light(from_x, from_y, 0) +
                                       m[c][1] * light(from_x, from_y, 1) +
                                       m[c][2] * light(from_x, from_y, 2);
                        if (from_y < 2)
                            continue;
                        ASSERT_NEAR(image.pixel(x, y)[c], expected, 0.01f) << x << "," << y << "," << c;
                    }
        }
    }
}

// A colour for each direction, smooth all around.
std::array<double, 3> light_from(const Imath::V3f& direction)
{
    const Imath::V3f d = direction.normalized();
    return {1.5 + static_cast<double>(d.x), 1.5 + static_cast<double>(d.y), 1.5 + static_cast<double>(d.z)};
}

// A map of that light, each pixel by the library's own geometry.
Bytes make_map(Imf::Envmap kind, int width, int height)
{
    ExrRecipe recipe;
    recipe.width = width;
    recipe.height = height;
    recipe.display = box(0, 0, 5, 5); // means nothing: the data window is the map
    recipe.attributes = [kind](Imf::Header& header) { Imf::addEnvmap(header, kind); };
    const Imath::Box2i window = box(0, 0, width, height);
    recipe.value = [=](int x, int y, std::size_t channel) {
        Imath::V3f direction =
            Imf::LatLongMap::direction(window, Imath::V2f(static_cast<float>(x), static_cast<float>(y)));
        if (kind == Imf::ENVMAP_CUBE) {
            // The place in a face is turned as faceAndPixelPosition gives it: look for the one that lands here.
            const auto face = static_cast<Imf::CubeMapFace>(y / width);
            for (int j = 0; j < width; ++j)
                for (int i = 0; i < width; ++i) {
                    const Imath::V2f inside(static_cast<float>(i), static_cast<float>(j));
                    const Imath::V2f at = Imf::CubeMap::pixelPosition(face, window, inside);
                    if (std::lround(at.x) == x && std::lround(at.y) == y)
                        direction = Imf::CubeMap::direction(face, window, inside);
                }
        }
        return static_cast<float>(light_from(direction)[channel]);
    };
    return make_exr(recipe);
}

void expect_panorama(const Bytes& bytes, int width, int height)
{
    const TemporaryFolder folder;
    const auto reader = open_panorama(folder.write("map.exr", bytes));
    ASSERT_EQ(reader->width(), width);
    ASSERT_EQ(reader->height(), height);
    EXPECT_TRUE(reader->warnings().empty());
    const RadianceImage image = read_all_rows(*reader);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            // This program's panoramas: the middle column is +X, +Z a quarter to its right.
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
            const double theta = (y + 0.5) / height * std::numbers::pi;
            const double d[3] = {std::sin(theta) * std::cos(phi), std::cos(theta),
                                 std::sin(theta) * std::sin(phi)};
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(image.pixel(x, y)[c], 1.5 + d[c], 0.02) << x << "," << y << "," << c;
        }
}

TEST(OpenExrMeaning, cube_maps_become_panoramas)
{
    expect_panorama(make_map(Imf::ENVMAP_CUBE, 16, 96), 64, 32);
}

TEST(OpenExrMeaning, maps_of_latitudes_and_longitudes_are_turned)
{
    expect_panorama(make_map(Imf::ENVMAP_LATLONG, 64, 32), 64, 32);
    expect_panorama(make_map(Imf::ENVMAP_LATLONG, 101, 50), 101, 50);
}

// A bright pixel of a cube gives its light wherever it is, at a face's middle, edge or corner.
TEST(OpenExrMeaning, cube_maps_keep_their_light)
{
    constexpr int size = 32;
    const double pi = std::numbers::pi;
    for (const auto& [px, py] : {std::pair(15, 15), {3, 20}, {2, 2}, {29, 1}}) {
        ExrRecipe recipe;
        recipe.width = size;
        recipe.height = 6 * size;
        recipe.attributes = [](Imf::Header& header) { Imf::addEnvmap(header, Imf::ENVMAP_CUBE); };
        for (const int face : {0, 2}) {
            recipe.value = [=](int x, int y, std::size_t) {
                return x == px && y == face * size + py ? 100.0f : 0.0f;
            };
            const TemporaryFolder folder;
            const RadianceImage image =
                read_all_rows(*open_panorama(folder.write("map.exr", make_exr(recipe))));
            double sum = 0.0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x)
                    sum += static_cast<double>(image.pixel(x, y)[0]) * 2.0 * pi / image.width *
                           (std::cos(pi * y / image.height) - std::cos(pi * (y + 1) / image.height));
            const double s = 2.0 * px / (size - 1) - 1.0, t = 2.0 * py / (size - 1) - 1.0;
            const double solid_angle = std::pow(2.0 / (size - 1), 2) / std::pow(1.0 + s * s + t * t, 1.5);
            EXPECT_NEAR(sum / (100.0 * solid_angle), 1.0, 0.03) << px << "," << py << " of face " << face;
        }
    }
}

TEST(OpenExrMeaning, an_envmap_without_sense_is_warned_of)
{
    ExrRecipe recipe;
    recipe.width = 20;
    recipe.height = 10;
    recipe.attributes = [](Imf::Header& header) { Imf::addEnvmap(header, Imf::ENVMAP_CUBE); };
    const TemporaryFolder folder;
    const auto reader = open_panorama(folder.write("map.exr", make_exr(recipe)));
    EXPECT_EQ(reader->width(), 20);
    ASSERT_EQ(reader->warnings().size(), 1u);
    EXPECT_NE(reader->warnings()[0].find("says cube map, but 20x10"), std::string::npos);
}

// A picture is compared with another pixel by pixel, whatever they are of.
TEST(OpenExrMeaning, maps_are_left_alone_where_no_panorama_is_asked_for)
{
    const Bytes bytes = make_map(Imf::ENVMAP_CUBE, 4, 24);
    EXPECT_EQ(read_exr(bytes).width, 4);
    EXPECT_EQ(inspect_exr(*open_bytes(bytes, "x")).height, 24);
    EXPECT_NE(inspect_exr(*open_bytes(bytes, "x")).detail.find("cube map"), std::string::npos);
}

} // namespace
} // namespace lambent::image
