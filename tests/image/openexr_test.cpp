// OpenEXR files as other programs make them, and as this one writes them.
#include "image/files/image_io.h"
#include "image/openexr/openexr.h"
#include "tests/image/exr_files.h"

#include <ImfArray.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

namespace lambent::image {
namespace {

using namespace lambent::test;
using Bytes = std::vector<std::uint8_t>;

// `channels` are those of the recipe that red, green and blue must come from.
void expect_read(const ExrRecipe& recipe, const std::array<std::size_t, 3>& channels, float tolerance = 0)
{
    const Bytes bytes = make_exr(recipe);
    for (const int portion : {1, 5, 1000}) {
        const RadianceImage image = read_exr(bytes, portion);
        ASSERT_EQ(image.width, recipe.width);
        ASSERT_EQ(image.height, recipe.height);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (std::size_t c = 0; c < 3; ++c) {
                    float expected = exr_value(x, y, channels[c]);
                    if (recipe.type == Imf::UINT)
                        expected = std::trunc(expected);
                    ASSERT_NEAR(image.pixel(x, y)[c], expected, tolerance) << x << "," << y << "," << c;
                }
    }
}

constexpr std::array<std::size_t, 3> in_order = {0, 1, 2};

TEST(OpenExr, each_pixel_type)
{
    expect_read({.width = 31, .height = 40, .type = Imf::FLOAT}, in_order);
    expect_read({.width = 31, .height = 40, .type = Imf::HALF}, in_order);
    expect_read({.width = 31, .height = 40, .type = Imf::UINT}, in_order);
}

TEST(OpenExr, each_lossless_compression)
{
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
          Imf::PIZ_COMPRESSION})
        for (const int tile : {0, 16})
            expect_read(
                {.width = 37, .height = 70, .type = Imf::HALF, .compression = compression, .tile = tile},
                in_order);
}

TEST(OpenExr, each_lossy_compression)
{
    for (const Imf::Compression compression :
         {Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION,
          Imf::DWAB_COMPRESSION})
        expect_read({.width = 37, .height = 300, .type = Imf::HALF, .compression = compression}, in_order,
                    12.0f);
}

// Large enough to be read by several threads.
TEST(OpenExr, a_large_file)
{
    expect_read({.width = 700, .height = 300, .type = Imf::HALF}, in_order);
    expect_read(
        {.width = 700, .height = 300, .type = Imf::HALF, .compression = Imf::PIZ_COMPRESSION, .tile = 64},
        in_order);
}

TEST(OpenExr, rows_stored_from_the_bottom)
{
    expect_read({.width = 20, .height = 50, .order = Imf::DECREASING_Y}, in_order);
    expect_read({.width = 20, .height = 50, .order = Imf::DECREASING_Y, .tile = 8}, in_order);
}

TEST(OpenExr, windows_that_do_not_start_at_the_origin)
{
    expect_read({.width = 20, .height = 50, .min_x = -7, .min_y = 1000}, in_order);
    expect_read({.width = 20, .height = 50, .min_x = 13, .min_y = -9, .tile = 16}, in_order);
}

TEST(OpenExr, the_finest_level_of_tiles)
{
    expect_read({.width = 40, .height = 30, .tile = 8, .levels = Imf::MIPMAP_LEVELS}, in_order);
}

TEST(OpenExr, picks_channels)
{
    expect_read({.channels = {"A", "B", "G", "R"}}, {3, 2, 1});
    expect_read({.channels = {"Z", "diffuse.B", "diffuse.G", "diffuse.R", "diffuse.A", "x.R"}}, {3, 2, 1});
    expect_read({.channels = {"R", "G", "B", "a.R", "a.G", "a.B"}}, in_order);
    expect_read({.channels = {"Y"}}, {0, 0, 0});
    expect_read({.channels = {"A", "Y"}, .tile = 4}, {1, 1, 1});
}

// The recipe's channel that a file's coverage is, none below 0; primaries change colours only.
void expect_alpha(const ExrRecipe& recipe, int channel)
{
    const TemporaryFolder folder;
    const Bytes bytes = make_exr(recipe);
    const auto path = folder / "alpha.exr";
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const std::vector<float> coverage = image::read_coverage(path);
    if (channel < 0) {
        EXPECT_TRUE(coverage.empty());
        return;
    }
    ASSERT_EQ(coverage.size(), static_cast<std::size_t>(recipe.width * recipe.height));
    for (int y = 0; y < recipe.height; ++y)
        for (int x = 0; x < recipe.width; ++x)
            ASSERT_EQ(coverage[static_cast<std::size_t>(y * recipe.width + x)],
                      exr_value(x, y, static_cast<std::size_t>(channel)));
}

TEST(OpenExr, coverage_is_the_alpha_of_the_colours)
{
    expect_alpha({.channels = {"A", "B", "G", "R"},
                  .attributes =
                      [](Imf::Header& header) {
                          Imf::addChromaticities(
                              header,
                              Imf::Chromaticities({0.708f, 0.292f}, {0.17f, 0.797f}, {0.131f, 0.046f}));
                      }},
                 0);
    expect_alpha({.channels = {"A", "diffuse.A", "diffuse.B", "diffuse.G", "diffuse.R"}}, 1);
    expect_alpha({.channels = {"A", "Y"}, .tile = 4}, 0);
    expect_alpha({.channels = {"B", "G", "R", "other.A"}}, -1);
}

TEST(OpenExr, the_first_part_with_colour)
{
    const TemporaryFolder folder;
    const std::string path = (folder / "parts.exr").string();
    std::vector<Imf::Header> headers(3, Imf::Header(4, 2));
    const char* const names[] = {"depth", "beauty", "more"};
    for (std::size_t i = 0; i < 3; ++i) {
        headers[i].setName(names[i]);
        headers[i].setType(Imf::SCANLINEIMAGE);
        for (const char* channel :
             i == 0 ? std::vector<const char*>{"Z"} : std::vector<const char*>{"R", "G", "B"})
            headers[i].channels().insert(channel, Imf::Channel(Imf::FLOAT));
    }
    {
        Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 3);
        for (int part = 0; part < 3; ++part) {
            std::vector<float> values(8, static_cast<float>(part) + 0.5f);
            Imf::FrameBuffer frame;
            for (const char* channel : {"R", "G", "B", "Z"})
                frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 16));
            Imf::OutputPart output(file, part);
            output.setFrameBuffer(frame);
            output.writePixels(2);
        }
    }
    EXPECT_EQ(read_exr(content_of(path)).values, std::vector<float>(24, 1.5f));
}

TEST(OpenExr, describes_a_file)
{
    const Bytes bytes = make_exr({.width = 20, .height = 10, .type = Imf::HALF, .tile = 8});
    const ImageInfo info = inspect_exr(*open_bytes(bytes, "test.exr"));
    EXPECT_EQ(info.format, "OpenEXR");
    EXPECT_EQ(info.detail, "16-bit float B G R, ZIP, tiled");
    EXPECT_EQ(info.width, 20);
    EXPECT_EQ(info.height, 10);
}

// What was written, as the OpenEXR library reads it.
TEST(OpenExr, writes_every_value_as_it_is)
{
    for (const int channels : {3, 4}) {
        RadianceImage image{19, 23, channels, {}};
        for (int i = 0; i < 19 * 23 * channels; ++i)
            image.values.push_back(std::ldexp(static_cast<float>(i) - 100.0f, i % 200 - 100));
        image.values[0] = std::numeric_limits<float>::infinity();
        image.values[4] = -std::numeric_limits<float>::infinity();
        image.values[8] = std::numeric_limits<float>::quiet_NaN();
        const TemporaryFolder folder;
        Imf::InputFile file(folder.write("out.exr", encode_exr(image)).c_str());
        EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
        EXPECT_EQ(file.header().channels().findChannel("A") != nullptr, channels == 4);
        const char* const names[] = {"R", "G", "B", "A"};
        for (int c = 0; c < channels; ++c) {
            ASSERT_EQ(file.header().channels()[names[c]].type, Imf::FLOAT);
            std::vector<float> back(19 * 23);
            Imf::FrameBuffer frame;
            frame.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(back.data()), 4, 4 * 19));
            file.setFrameBuffer(frame);
            file.readPixels(0, 22);
            for (int i = 0; i < 19 * 23; ++i)
                ASSERT_EQ(
                    std::bit_cast<std::uint32_t>(back[static_cast<std::size_t>(i)]),
                    std::bit_cast<std::uint32_t>(image.values[static_cast<std::size_t>(i * channels + c)]));
        }
    }
}

TEST(OpenExr, reads_what_it_writes_and_nan_and_infinity_unchanged)
{
    RadianceImage image{300, 250, 3, {}};
    for (int i = 0; i < 300 * 250 * 3; ++i)
        image.values.push_back(std::ldexp(static_cast<float>(i % 977) - 100.0f, i % 200 - 100));
    image.values[10] = std::numeric_limits<float>::infinity();
    image.values[11] = std::numeric_limits<float>::quiet_NaN();
    const RadianceImage back = read_exr(encode_exr(image));
    ASSERT_EQ(back.values.size(), image.values.size());
    EXPECT_EQ(std::memcmp(back.values.data(), image.values.data(), image.values.size() * sizeof(float)), 0);
}

} // namespace
} // namespace lambent::image
