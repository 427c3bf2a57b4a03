// PNGs whose pixels are whole but not what is around them: shown with a warning to those who listen, else refused.
#include "image/codes/png.h"
#include "tests/image/hostile.h"
#include "tests/image/png_writer.h"

#include <gtest/gtest.h>

namespace lambent::image {
namespace {

using namespace lambent::test;

void decode(std::span<const std::uint8_t> bytes, const std::string& name)
{
    (void)decode_png(bytes, name);
}

void decode_all_the_same(std::span<const std::uint8_t> bytes, const std::string& name)
{
    Warnings warnings;
    (void)decode_png(bytes, name, &warnings);
}

const Bytes rows = {0, 1, 2, 3, 0, 4, 5, 6};
const Bytes pixels = {1, 2, 3, 255, 4, 5, 6, 255};

Bytes file_with(const Bytes& between = {})
{
    return png_file({1, 2, 8, 2}, rows, between);
}

Bytes changed(Bytes file, std::size_t from_end)
{
    file[file.size() - from_end] ^= 1;
    return file;
}

TEST(PngDamage, whole_pixels_are_shown)
{
    const Bytes whole = file_with();
    Bytes wrong_text = png_chunk("tEXt", {'a', 0, 'b'});
    wrong_text.back() ^= 1;
    Bytes no_end = whole;
    no_end.resize(no_end.size() - 12);
    Bytes open_data = no_end;
    open_data.resize(open_data.size() - 4);
    for (const Bytes& damaged : {
             file_with(wrong_text),                     // the checksum of a text
             file_with(png_chunk("gAMA", {1})),         // a gamma of one byte
             file_with(png_chunk("pHYs", Bytes(9, 9))), // a unit that is none
             changed(whole, 13),                        // the checksum of the pixels' chunk
             no_end,                                    // no end mark
             open_data,                                 // nor the checksum before it
         }) {
        Warnings warnings;
        EXPECT_EQ(decode_png(damaged, "a.png", &warnings).bytes, pixels);
        ASSERT_LE(warnings.size(), 1u);
        if (warnings.empty())
            continue; // the library does not mind
        EXPECT_EQ(warnings[0].rfind("a.png: not a valid PNG: ", 0), 0u) << warnings[0];
        expect_refused(decode, damaged, "not a valid PNG");
    }
    Warnings warnings;
    decode_png(changed(whole, 13), "a.png", &warnings);
    decode_png(file_with(wrong_text), "a.png", &warnings);
    decode_png(no_end, "a.png", &warnings);
    EXPECT_EQ(warnings.size(), 3u);
    EXPECT_EQ(decode_png(whole, "a.png", &warnings).bytes, pixels);
    EXPECT_EQ(warnings.size(), 3u) << "of what is whole nothing is said";
}

TEST(PngDamage, the_palette_and_its_alpha_are_kept)
{
    const Bytes palette = png_chunk("PLTE", {9, 8, 7, 6, 5, 4}) + png_chunk("tRNS", {100});
    Bytes file = png_file({2, 1, 8, 3}, {0, 1, 0}, palette + png_chunk("gAMA", {1}));
    file.resize(file.size() - 12);
    Warnings warnings;
    EXPECT_EQ(decode_png(file, "a.png", &warnings).bytes, (Bytes{6, 5, 4, 255, 9, 8, 7, 100}));
    EXPECT_EQ(warnings.size(), 1u);
}

TEST(PngDamage, pixels_that_are_not_all_there_are_refused)
{
    const Bytes whole = file_with();
    // The end mark has 12 bytes, the checksum before it 4, and that of the zlib stream 4.
    for (std::size_t length = 0; length + 20 < whole.size(); ++length)
        expect_refused(decode_all_the_same, std::span(whole).first(length), "");
    expect_refused(decode_all_the_same, png_file({2, 2, 8, 0}, {0, 1, 2}), "not a valid PNG");
    expect_refused(decode_all_the_same, png_file({200000, 100000, 8, 2}, {0}), "above the limit");
    expect_refused(decode_all_the_same, png_file({16384, 16384, 8, 2}, {0}), "cannot hold");
}

TEST(PngDamage, mutations)
{
    const Bytes palette =
        png_chunk("PLTE", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}) + png_chunk("tRNS", {9, 8});
    for (const Bytes& valid : {file_with(), png_file({3, 3, 8, 0, 1}, Bytes(15, 0)),
                               png_file({4, 2, 4, 3}, {0, 1, 2, 0, 3, 0}, palette)})
        expect_mutations_survived(decode_all_the_same, valid, 2000);
}

} // namespace
} // namespace lambent::image
