// Radiance pictures in every variant, made by the test's own writer.
#include "image/radiance/radiance_hdr.h"
#include "tests/image/radiance_writer.h"
#include "tests/image/temporary_folder.h"

#include <gtest/gtest.h>

#include <random>

namespace lambent::image {
namespace {

using namespace lambent::test;

RadianceImage read(const Bytes& bytes)
{
    const auto reader = open_radiance_hdr(open_bytes(bytes, "test.hdr"));
    RadianceImage image{reader->width(), reader->height(), 3, {}};
    image.values.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3);
    reader->read_rows(image.height, image.values.data());
    return image;
}

void expect_pixels(const RadianceImage& image, const Pixels& pixels)
{
    ASSERT_EQ(image.values.size(), pixels.size() * 3);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_EQ(image.values[3 * i + c], radiance_of(pixels[i])[c]) << "pixel " << i;
}

std::string usual_resolution(std::size_t width, std::size_t height)
{
    return "-Y " + std::to_string(height) + " +X " + std::to_string(width);
}

TEST(Radiance, reads_flat_pixels)
{
    const Pixels pixels = {{128, 0, 255, 129}, {0, 0, 0, 0},     {255, 255, 255, 255},
                           {1, 2, 128, 1},     {2, 2, 128, 130}, {7, 8, 9, 0}};
    const RadianceImage image = read(radiance_header("-Y 2 +X 3") + flat_scanline(pixels));
    EXPECT_EQ(image.width, 3);
    EXPECT_EQ(image.height, 2);
    expect_pixels(image, pixels);
    EXPECT_EQ(image.values[0], 1.0f);
    EXPECT_EQ(image.values[2], 255.0f / 128.0f);
}

TEST(Radiance, reads_each_encoding_at_each_width)
{
    for (const std::size_t width :
         {1u, 2u, 7u, 8u, 9u, 127u, 128u, 129u, 255u, 256u, 1000u, 32767u, 32768u, 40000u}) {
        const Pixels pixels = mixed_pixels(width, static_cast<unsigned>(width));
        expect_pixels(read(radiance_header(usual_resolution(width, 1)) + flat_scanline(pixels)), pixels);
        expect_pixels(read(radiance_header(usual_resolution(width, 1)) + repeat_scanline(pixels)), pixels);
        if (width >= 8 && width <= 32767)
            expect_pixels(read(radiance_header(usual_resolution(width, 1)) + plane_scanline(pixels)), pixels);
    }
}

TEST(Radiance, reads_repeats_of_a_multiple_of_256)
{
    Pixels pixels(1 + 512, Pixel{9, 200, 3, 128});
    const Bytes body = {9, 200, 3, 128, 1, 1, 1, 0, 1, 1, 1, 2};
    expect_pixels(read(radiance_header("-Y 1 +X 513") + body), pixels);
}

TEST(Radiance, reads_encodings_mixed_by_scanline)
{
    constexpr std::size_t width = 300;
    Pixels all;
    Bytes bytes = radiance_header(usual_resolution(width, 30));
    for (unsigned y = 0; y < 30; ++y) {
        const Pixels pixels = mixed_pixels(width, y);
        all.insert(all.end(), pixels.begin(), pixels.end());
        bytes = bytes + (y % 3 == 0   ? flat_scanline(pixels)
                         : y % 3 == 1 ? repeat_scanline(pixels)
                                      : plane_scanline(pixels));
    }
    expect_pixels(read(bytes), all);
}

// Longer than the reader's buffer many times over, in calls of every kind of length.
TEST(Radiance, reads_a_large_file_in_any_portions)
{
    constexpr std::size_t width = 3000, height = 450;
    Pixels all;
    Bytes bytes = radiance_header(usual_resolution(width, height));
    for (unsigned y = 0; y < height; ++y) {
        const Pixels pixels = mixed_pixels(width, y);
        all.insert(all.end(), pixels.begin(), pixels.end());
        const Bytes scanline = y % 5 == 0 ? flat_scanline(pixels) : plane_scanline(pixels);
        bytes.insert(bytes.end(), scanline.begin(), scanline.end());
    }
    ASSERT_GT(bytes.size(), 1u << 21);
    for (const int portion : {1, 7, 64, 450}) {
        const auto reader = open_radiance_hdr(open_bytes(bytes, "test.hdr"));
        RadianceImage image{reader->width(), reader->height(), 3, std::vector<float>(width * height * 3)};
        for (int y = 0; y < image.height; y += portion)
            reader->read_rows(std::min(portion, image.height - y), image.pixel(0, y));
        expect_pixels(image, all);
    }
}

// For each of the eight orders, the pixels in the order of the file.
struct Order {
    const char* major;
    const char* minor;
};
constexpr Order orders[] = {{"-Y", "+X"}, {"-Y", "-X"}, {"+Y", "+X"}, {"+Y", "-X"},
                            {"+X", "-Y"}, {"-X", "-Y"}, {"+X", "+Y"}, {"-X", "+Y"}};

void expect_order_read(const Order& order, int width, int height)
{
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const Pixels pixels = mixed_pixels(count, 99);
    const auto at = [&](int x, int y) { return pixels[static_cast<std::size_t>(y * width + x)]; };
    const bool rows = order.major[1] == 'Y';
    const int scanlines = rows ? height : width, length = rows ? width : height;
    // -Y and +X go down and right, as coordinates in memory do; +Y and -X go against them.
    const auto along = [](const char* axis, int index, int size) {
        const bool with_memory = (axis[0] == '-') == (axis[1] == 'Y');
        return with_memory ? index : size - 1 - index;
    };
    Bytes bytes = radiance_header(std::string(order.major) + " " + std::to_string(scanlines) + " " +
                                  order.minor + " " + std::to_string(length));
    for (int i = 0; i < scanlines; ++i) {
        Pixels scanline;
        for (int j = 0; j < length; ++j) {
            const int a = along(order.major, i, scanlines), b = along(order.minor, j, length);
            scanline.push_back(rows ? at(b, a) : at(a, b));
        }
        bytes = bytes + (length >= 8 ? plane_scanline(scanline) : flat_scanline(scanline));
    }
    const RadianceImage image = read(bytes);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    expect_pixels(image, pixels);
}

TEST(Radiance, reads_all_eight_orders)
{
    for (const Order& order : orders) {
        SCOPED_TRACE(std::string(order.major) + order.minor);
        expect_order_read(order, 3, 2);
        expect_order_read(order, 11, 5);
        expect_order_read(order, 9, 200);
    }
}

// Indented lines are the history of pictures that went into this one.
TEST(Radiance, divides_by_all_exposures)
{
    const Bytes header = radiance_header(
        "-Y 1 +X 1", "EXPOSURE=2\nVIEW= -vtv\nEXPOSURE= 4.0\n# EXPOSURE=100\n\tEXPOSURE=100\n");
    const RadianceImage image = read(header + Bytes{128, 64, 32, 129});
    EXPECT_EQ(image.values, (std::vector<float>{1.0f / 8, 0.5f / 8, 0.25f / 8}));
}

TEST(Radiance, divides_by_the_colour_correction)
{
    const Bytes header = radiance_header("-Y 1 +X 1", "COLORCORR= 2 0.5\t1e0\nEXPOSURE=1e-1\n");
    const RadianceImage image = read(header + Bytes{128, 64, 32, 129});
    EXPECT_FLOAT_EQ(image.values[0], 5.0f);
    EXPECT_FLOAT_EQ(image.values[1], 10.0f);
    EXPECT_FLOAT_EQ(image.values[2], 2.5f);
}

TEST(Radiance, takes_headers_as_other_programs_write_them)
{
    const Bytes body = {128, 128, 128, 129};
    for (const char* header :
         {"#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n", "#?RADIANCE\n\n-Y 1 +X 1\n",
          "#?x\n# made by hand\n\n-Y 1 +X 1\n", "#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n",
          "#?RADIANCE\nPRIMARIES=0.640 0.330 0.300 0.600 0.150 0.060 0.333 0.333\nGAMMA=1.0\nPIXASPECT=1\n"
          "FORMAT= 32-bit_rle_rgbe \n\n-Y 1  +X 1\n"})
        EXPECT_EQ(read(bytes_of(header) + body).values, (std::vector<float>{1, 1, 1})) << header;
}

TEST(Radiance, describes_a_file)
{
    const Bytes bytes = radiance_header("+X 3 -Y 2") + Bytes(24, 128);
    const ImageInfo info = inspect_radiance_hdr(*open_bytes(bytes, "test.hdr"));
    EXPECT_EQ(info.format, "Radiance HDR");
    EXPECT_EQ(info.width, 3);
    EXPECT_EQ(info.height, 2);
    EXPECT_NE(info.detail.find("+X 3 -Y 2"), std::string::npos);
}

// Written and read again, every pixel is what it was, at widths on both sides of where run lengths begin
// and end.
TEST(Radiance, writes_what_it_reads)
{
    for (const std::size_t width : {1u, 7u, 8u, 130u, 1021u, 32767u, 32768u}) {
        const Pixels pixels = mixed_pixels(width * 3, 5);
        RadianceImage image{static_cast<int>(width), 3, 3, {}};
        for (const Pixel& pixel : pixels)
            for (const float value : radiance_of(pixel))
                image.values.push_back(value);
        expect_pixels(read(encode_radiance_hdr(image)), pixels);
    }
}

TEST(Radiance, writes_runs_shorter_than_pixels)
{
    const RadianceImage black{1000, 10, 3, std::vector<float>(30000)};
    EXPECT_LT(encode_radiance_hdr(black).size(), 1000u);
    // Without any run, a count for each 128 bytes is all that is added.
    std::minstd_rand random(1);
    RadianceImage noise{1000, 10, 3, {}};
    for (int i = 0; i < 30000; ++i)
        noise.values.push_back(std::exp2(static_cast<float>(random() % 1000) / 50.0f));
    EXPECT_LT(encode_radiance_hdr(noise).size(), 1000u * 10 * 4 + 10 * (4 + 4 * 8) + 100);
}

TEST(Radiance, drops_coverage)
{
    const RadianceImage image{1, 1, 4, {1, 2, 4, 0.5f}};
    EXPECT_EQ(read(encode_radiance_hdr(image)).values, (std::vector<float>{1, 2, 4}));
}

} // namespace
} // namespace lambent::image
