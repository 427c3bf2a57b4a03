// PNG: every colour type from files made by hand, and what must be refused.
#include "image/codes/png.h"
#include "tests/image/png_writer.h"
#include "tests/image/hostile.h"

#include <gtest/gtest.h>

#include <cstring>

namespace lambent::image {
namespace {

using namespace lambent::test;

constexpr std::uint8_t grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgba = 6;

void expect_decoded(const Bytes& file, int bits, const std::vector<int>& rgba_codes)
{
    const CodeImage image = decode_png(file, "test.png");
    EXPECT_EQ(image.channels, 4);
    EXPECT_EQ(image.bits, bits);
    ASSERT_EQ(image.bytes.size(), rgba_codes.size() * static_cast<std::size_t>(bits) / 8);
    for (std::size_t i = 0; i < rgba_codes.size(); ++i) {
        std::uint16_t code = image.bytes[i * static_cast<std::size_t>(bits) / 8];
        if (bits == 16)
            std::memcpy(&code, image.bytes.data() + 2 * i, 2);
        ASSERT_EQ(code, rgba_codes[i]) << "channel " << i % 4 << " of pixel " << i / 4;
    }
}

TEST(Png, grey_of_1_2_4_8_bits)
{
    expect_decoded(png_file({2, 1, 1, grey}, {0, 0b01000000}), 8, {0, 0, 0, 255, 255, 255, 255, 255});
    expect_decoded(png_file({2, 1, 2, grey}, {0, 0b01100000}), 8, {85, 85, 85, 255, 170, 170, 170, 255});
    expect_decoded(png_file({2, 1, 4, grey}, {0, 0x1e}), 8, {17, 17, 17, 255, 238, 238, 238, 255});
    expect_decoded(png_file({2, 1, 8, grey}, {0, 3, 250}), 8, {3, 3, 3, 255, 250, 250, 250, 255});
}

TEST(Png, colour_of_8_bits)
{
    expect_decoded(png_file({1, 2, 8, rgb}, {0, 1, 2, 3, 0, 4, 5, 6}), 8, {1, 2, 3, 255, 4, 5, 6, 255});
    expect_decoded(png_file({1, 1, 8, rgba}, {0, 1, 2, 3, 4}), 8, {1, 2, 3, 4});
    expect_decoded(png_file({1, 1, 8, grey_alpha}, {0, 9, 4}), 8, {9, 9, 9, 4});
}

TEST(Png, all_types_of_16_bits)
{
    expect_decoded(png_file({1, 1, 16, grey}, {0, 0x12, 0x34}), 16, {0x1234, 0x1234, 0x1234, 0xffff});
    expect_decoded(png_file({1, 1, 16, rgb}, {0, 1, 2, 3, 4, 5, 6}), 16, {0x0102, 0x0304, 0x0506, 0xffff});
    expect_decoded(png_file({1, 1, 16, grey_alpha}, {0, 1, 2, 3, 4}), 16, {0x0102, 0x0102, 0x0102, 0x0304});
    expect_decoded(png_file({1, 1, 16, rgba}, {0, 1, 2, 3, 4, 5, 6, 7, 8}), 16,
                   {0x0102, 0x0304, 0x0506, 0x0708});
}

TEST(Png, palette_with_alpha)
{
    const Bytes chunks =
        png_chunk("PLTE", {10, 20, 30, 40, 50, 60, 70, 80, 90}) + png_chunk("tRNS", {0, 128});
    const std::vector<int> expected = {70, 80, 90, 255, 40, 50, 60, 128, 10, 20, 30, 0};
    expect_decoded(png_file({3, 1, 8, palette}, {0, 2, 1, 0}, chunks), 8, expected);
    expect_decoded(png_file({3, 1, 4, palette}, {0, 0x21, 0x00}, chunks), 8, expected);
    expect_decoded(png_file({3, 1, 2, palette}, {0, 0b10010000}, chunks), 8, expected);
}

// The standard leaves it to the decoder; this is what others do, too.
TEST(Png, colours_missing_from_the_palette_are_black)
{
    expect_decoded(png_file({2, 1, 8, palette}, {0, 0, 1}, png_chunk("PLTE", {1, 2, 3})), 8,
                   {1, 2, 3, 255, 0, 0, 0, 255});
}

TEST(Png, one_transparent_colour)
{
    expect_decoded(png_file({2, 1, 8, rgb}, {0, 1, 2, 3, 1, 2, 4}, png_chunk("tRNS", {0, 1, 0, 2, 0, 3})), 8,
                   {1, 2, 3, 0, 1, 2, 4, 255});
    expect_decoded(png_file({2, 1, 2, grey}, {0, 0b01100000}, png_chunk("tRNS", {0, 1})), 8,
                   {85, 85, 85, 0, 170, 170, 170, 255});
    expect_decoded(png_file({2, 1, 16, grey}, {0, 1, 2, 1, 3}, png_chunk("tRNS", {1, 2})), 16,
                   {0x0102, 0x0102, 0x0102, 0, 0x0103, 0x0103, 0x0103, 0xffff});
}

// The same 2x2 picture in each filter: none; left; above; average; Paeth.
TEST(Png, all_filters)
{
    const std::vector<int> expected = {10, 10, 10, 255, 30, 30, 30, 255, 20, 20, 20, 255, 50, 50, 50, 255};
    const PngShape shape{2, 2, 8, grey};
    expect_decoded(png_file(shape, {0, 10, 30, 0, 20, 50}), 8, expected);
    expect_decoded(png_file(shape, {1, 10, 20, 1, 20, 30}), 8, expected);
    expect_decoded(png_file(shape, {0, 10, 30, 2, 10, 20}), 8, expected);
    expect_decoded(png_file(shape, {0, 10, 30, 3, 15, 25}), 8, expected);
    // Left 20, above 30, above left 10: estimate 40, nearest is 30.
    expect_decoded(png_file(shape, {0, 10, 30, 4, 10, 20}), 8, expected);
}

// Adam7 on 3x3: pass 1 has (0,0); pass 5 (0,2) (2,2); 4 (2,0); 6 (1,0) (1,2); 7 row 1.
TEST(Png, interlaced)
{
    const Bytes rows = {0, 1, /*pass 4*/ 0, 3, /*pass 5*/ 0, 7, 9, /*pass 6*/ 0, 2, 0, 8, /*pass 7*/ 0, 4,
                        5, 6};
    std::vector<int> expected;
    for (const int code : {1, 2, 3, 4, 5, 6, 7, 8, 9})
        expected.insert(expected.end(), {code, code, code, 255});
    expect_decoded(png_file({3, 3, 8, grey, 1}, rows), 8, expected);
}

TEST(Png, large_interlaced)
{
    // All zero whatever the pass, and large enough for the reader to look through it before it takes memory.
    constexpr std::uint32_t side = 2100;
    const std::uint32_t starts[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                        {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    std::size_t length = 0;
    for (const auto& [x, y, dx, dy] : starts)
        length += ((side - x + dx - 1) / dx + 1) * std::size_t{(side - y + dy - 1) / dy};
    const Bytes file = png_file({side, side, 8, grey, 1}, Bytes(length));
    const CodeImage image = decode_png(file, "test.png");
    EXPECT_EQ(image.bytes.size(), std::size_t{side} * side * 4);
    EXPECT_EQ(image.bytes[0], 0);
    EXPECT_EQ(image.bytes[3], 255);
    expect_refused([](auto bytes, const auto& name) { decode_png(bytes, name); },
                   png_file({side, side, 8, grey, 1}, Bytes(length / 2)), "not a valid PNG");
}

TEST(Png, describes_a_file)
{
    const ImageInfo info = inspect_png(png_file({3, 3, 16, rgba, 1}, Bytes(20)), "test.png");
    EXPECT_EQ(info.format, "PNG");
    EXPECT_EQ(info.detail, "16-bit RGBA, interlaced");
    EXPECT_EQ(info.width, 3);
    EXPECT_EQ(info.height, 3);
}

CodeImage pattern(int channels, int bits)
{
    CodeImage image{37, 11, channels, bits, {}};
    image.bytes.resize(static_cast<std::size_t>(37 * 11 * channels * bits / 8));
    for (std::size_t i = 0; i < image.bytes.size(); ++i)
        image.bytes[i] = static_cast<std::uint8_t>(i * i / 7 + i);
    return image;
}

TEST(Png, gives_back_what_was_written)
{
    for (const int channels : {3, 4})
        for (const int bits : {8, 16}) {
            const CodeImage image = pattern(channels, bits);
            const CodeImage back = decode_png(encode_png(image), "test.png");
            ASSERT_EQ(back.bits, bits);
            const auto size = static_cast<std::size_t>(bits / 8);
            for (std::size_t i = 0; i < 37 * 11; ++i) {
                const std::uint8_t* const to = back.bytes.data() + i * 4 * size;
                const std::uint8_t* const from =
                    image.bytes.data() + i * static_cast<std::size_t>(channels) * size;
                ASSERT_EQ(std::memcmp(to, from, static_cast<std::size_t>(channels) * size), 0) << i;
                if (channels == 3) {
                    ASSERT_EQ(to[3 * size], 255);
                }
            }
        }
}

void decode(std::span<const std::uint8_t> bytes, const std::string& name)
{
    (void)decode_png(bytes, name);
}

TEST(PngBad, files)
{
    const Bytes valid = png_file({1, 2, 8, rgb}, {0, 1, 2, 3, 0, 4, 5, 6});
    const Bytes end = png_chunk("IEND", {});
    Bytes wrong_crc = valid;
    wrong_crc[valid.size() - end.size() - 1] ^= 1;
    Bytes wrong_text_crc = png_file({1, 1, 8, grey}, {0, 1}, png_chunk("tEXt", bytes_of({"a\0b", 3})));
    wrong_text_crc[33 + 8 + 3] ^= 1;
    struct Case {
        Bytes bytes;
        const char* reason;
    };
    for (const Case& bad : {
             Case{{}, "not a valid PNG"},
             Case{bytes_of("just some text, longer than a signature"), "not a valid PNG"},
             Case{wrong_crc, "checksum"},
             Case{wrong_text_crc, "checksum"},
             Case{png_file({0, 1, 8, rgb}, {0}), "not a valid PNG"},
             Case{png_file({0xffffffff, 1, 8, rgb}, {0}), "not a valid PNG"},
             Case{png_file({200000, 100000, 8, rgb}, {0}), "above the limit"},
             Case{png_file({65536, 65536, 8, rgb}, {0}), "above the limit"},
             Case{png_file({16384, 16384, 8, rgb}, {0}), "cannot hold"},
             Case{png_file({1, 1, 3, grey}, {0, 1}), "not a valid PNG"},
             Case{png_file({1, 1, 8, 5}, {0, 1}), "not a valid PNG"},
             Case{png_file({1, 1, 8, palette}, {0, 1}), "not a valid PNG"},
             Case{png_file({1, 1, 8, grey}, {5, 1}), "not a valid PNG"},
             Case{png_file({2, 2, 8, grey}, {0, 1, 2}), "not a valid PNG"},
             Case{png_start({1, 1, 8, grey}) + end, "not a valid PNG"},
         })
        expect_refused(decode, bad.bytes, bad.reason);
}

TEST(PngBad, every_truncation)
{
    // The library does not miss the checksum of the empty chunk at the end.
    constexpr std::size_t unread = 4;
    expect_truncations_refused(decode, png_file({3, 2, 8, rgba}, Bytes(26, 0)), unread);
    expect_truncations_refused(decode, png_file({3, 3, 8, grey, 1}, Bytes(15, 0)), unread);
    expect_truncations_refused(decode, encode_png(pattern(3, 8)), unread);
}

// Checksums catch nearly all changes; with them made right again, the decoder itself is met.
void decode_with_right_checksums(std::span<const std::uint8_t> bytes, const std::string& name)
{
    Bytes fixed(bytes.begin(), bytes.end());
    for (std::size_t at = 8; at + 12 <= fixed.size();) {
        const std::uint64_t length = std::uint64_t{fixed[at]} << 24 | std::uint64_t{fixed[at + 1]} << 16 |
                                     std::uint64_t{fixed[at + 2]} << 8 | fixed[at + 3];
        if (length > fixed.size() - at - 12)
            break;
        const auto begin = fixed.begin() + static_cast<std::ptrdiff_t>(at);
        const Bytes chunk = png_chunk(std::string(begin + 4, begin + 8),
                                      Bytes(begin + 8, begin + 8 + static_cast<std::ptrdiff_t>(length)));
        std::copy(chunk.begin(), chunk.end(), begin);
        at += chunk.size();
    }
    (void)decode_png(fixed, name);
}

TEST(PngBad, mutations)
{
    const Bytes stored = png_file({3, 3, 8, grey, 1}, Bytes(15, 0));
    const Bytes colours = png_file({4, 2, 4, palette}, {0, 1, 2, 0, 3, 0},
                                   png_chunk("PLTE", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}) +
                                       png_chunk("tRNS", {9, 8}) + png_chunk("gAMA", {0, 0, 177, 143}));
    for (const Bytes& valid : {stored, colours, encode_png(pattern(3, 8)), encode_png(pattern(4, 16))}) {
        expect_mutations_survived(decode, valid, 500);
        expect_mutations_survived(decode_with_right_checksums, valid, 2000);
    }
}

} // namespace
} // namespace lambent::image
