// JPEG: one file made by hand, the rest by the library.
#include "image/codes/jpeg.h"
#include "tests/image/hostile.h"
#include "tests/image/jpeg_files.h"

#include <gtest/gtest.h>

#include <turbojpeg.h>

#include <cmath>

namespace lambent::image {
namespace {

using namespace lambent::test;

TEST(Jpeg, a_file_made_by_hand)
{
    const CodeImage image = decode_jpeg(tiny_jpeg(), "test.jpg");
    EXPECT_EQ(image.width, 8);
    EXPECT_EQ(image.height, 8);
    EXPECT_EQ(image.bits, 8);
    ASSERT_EQ(image.bytes.size(), 8u * 8 * 4);
    for (std::size_t i = 0; i < image.bytes.size(); ++i)
        ASSERT_EQ(image.bytes[i], i % 4 == 3 ? 255 : 136) << i;
}

TEST(Jpeg, colour_grey_progressive_and_subsampled)
{
    for (const Encoding& encoding :
         {Encoding{}, Encoding{TJPF_RGB, TJSAMP_420, 0}, Encoding{TJPF_RGB, TJSAMP_422, TJFLAG_PROGRESSIVE},
          Encoding{TJPF_RGB, TJSAMP_440, 0}, Encoding{TJPF_GRAY, TJSAMP_GRAY, TJFLAG_PROGRESSIVE}}) {
        const CodeImage image = decode_jpeg(encode(33, 18, encoding), "test.jpg");
        ASSERT_EQ(image.bytes.size(), 33u * 18 * 4);
        for (int y = 0; y < 18; ++y)
            for (int x = 0; x < 33; ++x)
                for (int c = 0; c < 3; ++c) {
                    const int expected = 40 + 2 * x + 3 * y + (encoding.format == TJPF_GRAY ? 0 : 20 * c);
                    const int code = image.bytes[static_cast<std::size_t>((y * 33 + x) * 4 + c)];
                    ASSERT_NEAR(code, expected, 8) << x << "," << y << "," << c;
                }
    }
}

TEST(Jpeg, every_subsampling_that_the_library_decodes)
{
    // Of the luminance, for each sample of colour: 444, 422, 440, 420, 411, 410, 441, and some without a name.
    for (const Sampling& sampling :
         {Sampling{1, 1}, Sampling{2, 1}, Sampling{1, 2}, Sampling{2, 2}, Sampling{4, 1}, Sampling{4, 2},
          Sampling{1, 4}, Sampling{3, 1}, Sampling{3, 2}, Sampling{2, 4}}) {
        const CodeImage image = decode_jpeg(encode_sampled(48, 40, sampling), "test.jpg");
        ASSERT_EQ(image.bytes.size(), 48u * 40 * 4);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 48; ++x)
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(image.bytes[static_cast<std::size_t>((y * 48 + x) * 4 + c)], slope(x, y, c),
                                14)
                        << sampling.across << "x" << sampling.down << " at " << x << "," << y << "," << c;
    }
}

TEST(Jpeg, gives_back_nearly_what_was_written)
{
    for (const int channels : {3, 4}) {
        CodeImage image{50, 40, channels, 8, {}};
        for (int i = 0; i < 50 * 40; ++i)
            for (int c = 0; c < channels; ++c)
                image.bytes.push_back(static_cast<std::uint8_t>(
                    c == 3 ? 7 : 128 + 100 * std::sin(0.01 * i + 0.3 * (i % 50) * 0.2 + c)));
        const CodeImage back = decode_jpeg(encode_jpeg(image), "test.jpg");
        double sum = 0;
        for (std::size_t i = 0; i < 50 * 40; ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const int difference =
                    back.bytes[i * 4 + c] - image.bytes[i * static_cast<std::size_t>(channels) + c];
                ASSERT_LE(std::abs(difference), 10);
                sum += std::abs(difference);
            }
        EXPECT_LT(sum / (50 * 40 * 3), 1.5);
    }
}

TEST(Jpeg, describes_a_file)
{
    const ImageInfo info =
        inspect_jpeg(encode(33, 18, {TJPF_RGB, TJSAMP_420, TJFLAG_PROGRESSIVE}), "test.jpg");
    EXPECT_EQ(info.format, "JPEG");
    EXPECT_EQ(info.detail, "8-bit colour, progressive");
    EXPECT_EQ(info.width, 33);
    EXPECT_EQ(info.height, 18);
}

void decode(std::span<const std::uint8_t> bytes, const std::string& name)
{
    (void)decode_jpeg(bytes, name);
}

TEST(JpegBad, files)
{
    const Bytes tables = table_segments();
    Bytes many_scans = start_of_image + tables + frame(8, 8, 0xc2);
    for (int i = 0; i < 101; ++i)
        many_scans = many_scans + Bytes{0xff, 0xda, 0, 8, 1, 1, 0, 0, 0, 0, 0b01000111};
    struct Case {
        Bytes bytes;
        const char* reason;
    };
    for (const Case& bad : {
             Case{{}, "ends after 0 bytes"},
             Case{bytes_of("just some text"), "not a JPEG"},
             Case{start_of_image, "ends after 2 bytes"},
             Case{start_of_image + end_of_image, "holds no image"},
             Case{start_of_image + frame(8, 8) + end_of_image, "holds no image"},
             Case{start_of_image + frame(8, 8) + frame(8, 8) + scan + end_of_image, "two frame headers"},
             Case{start_of_image + tables + frame(0, 8) + scan + end_of_image, "not positive"},
             Case{start_of_image + tables + frame(8, 0) + scan + end_of_image, "not positive"},
             Case{start_of_image + tables + frame(65535, 65535) + scan + end_of_image, "above the limit"},
             Case{start_of_image + tables + frame(16000, 16000) + scan + end_of_image, "cannot hold"},
             Case{start_of_image + tables + frame(8, 8, 0xc1, 12) + scan + end_of_image, "12-bit"},
             Case{start_of_image + tables + frame(16, 8) + scan + end_of_image, "not a valid JPEG"},
             Case{start_of_image + Bytes{0xff, 0xe0, 0, 1} + end_of_image, "length 1"},
             Case{many_scans + end_of_image, "101 scans"},
             Case{encode(16, 16, {TJPF_CMYK, TJSAMP_444, 0}), "CMYK"},
         })
        expect_refused(decode, bad.bytes, bad.reason);
}

TEST(JpegBad, every_truncation)
{
    expect_truncations_refused(decode, tiny_jpeg());
    expect_truncations_refused(decode, encode(20, 10, {TJPF_RGB, TJSAMP_420, 0}));
    expect_truncations_refused(decode, encode(20, 10, {TJPF_RGB, TJSAMP_444, TJFLAG_PROGRESSIVE}));
}

TEST(JpegBad, mutations)
{
    expect_mutations_survived(decode, tiny_jpeg(), 3000);
    expect_mutations_survived(decode, encode(20, 10, {TJPF_RGB, TJSAMP_420, 0}), 3000);
    expect_mutations_survived(decode, encode(20, 10, {TJPF_RGB, TJSAMP_444, TJFLAG_PROGRESSIVE}), 3000);
}

} // namespace
} // namespace lambent::image
