// JPEGs that the library reads with a complaint: shown with a warning to those who listen, else refused.
#include "image/codes/jpeg.h"
#include "tests/image/hostile.h"
#include "tests/image/jpeg_files.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lambent::image {
namespace {

using namespace lambent::test;

void decode_all_the_same(std::span<const std::uint8_t> bytes, const std::string& name)
{
    Warnings warnings;
    (void)decode_jpeg(bytes, name, &warnings);
}

void decode(std::span<const std::uint8_t> bytes, const std::string& name)
{
    (void)decode_jpeg(bytes, name);
}

// Where a marker begins.
std::ptrdiff_t place_of(const Bytes& file, std::uint8_t marker)
{
    const Bytes two = {0xff, marker};
    return std::search(file.begin(), file.end(), two.begin(), two.end()) - file.begin();
}

TEST(JpegDamage, stray_bytes_before_a_marker)
{
    const Bytes whole = encode(24, 16, {});
    Bytes stray = whole;
    stray.insert(stray.begin() + place_of(whole, 0xc4), 5, 0); // before the Huffman tables
    Warnings warnings;
    EXPECT_EQ(decode_jpeg(stray, "a.jpg", &warnings).bytes, decode_jpeg(whole, "a.jpg").bytes);
    EXPECT_EQ(warnings,
              Warnings{"a.jpg: damaged JPEG: Corrupt JPEG data: 5 extraneous bytes before marker 0xc4"});
    expect_refused(decode, stray, "5 extraneous bytes");
}

TEST(JpegDamage, an_early_end_leaves_what_was_there)
{
    for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
        const Bytes whole = encode(64, 64, {TJPF_RGB, TJSAMP_444, flags});
        const CodeImage all = decode_jpeg(whole, "a.jpg");
        Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() - 40));
        Warnings warnings;
        const CodeImage some = decode_jpeg(cut, "a.jpg", &warnings);
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_EQ(warnings[0], "a.jpg: damaged JPEG: it ends after " + std::to_string(cut.size()) +
                                   " bytes, before its end marker");
        EXPECT_EQ(inspect_jpeg(cut, "a.jpg", &warnings).height, 64);
        EXPECT_EQ(warnings.size(), 2u);
        ASSERT_EQ(some.bytes.size(), all.bytes.size());
        if (flags == 0) { // the rows of blocks before the cut are as they were
            EXPECT_TRUE(std::equal(all.bytes.begin(), all.bytes.begin() + 64 * 8 * 4, some.bytes.begin()));
        }
        expect_refused(decode, cut, "before its end marker");
    }
    // Only the end mark is missing: nothing is lost.
    Bytes open = tiny_jpeg();
    open.resize(open.size() - 2);
    Warnings warnings;
    EXPECT_EQ(decode_jpeg(open, "a.jpg", &warnings).bytes, decode_jpeg(tiny_jpeg(), "a.jpg").bytes);
    EXPECT_EQ(warnings.size(), 1u);
}

TEST(JpegDamage, nothing_is_shown_of_what_ends_before_its_pixels)
{
    const Bytes whole = encode(20, 10, {});
    for (std::ptrdiff_t length = 0; length < place_of(whole, 0xda); ++length)
        expect_refused(decode_all_the_same, std::span(whole).first(static_cast<std::size_t>(length)), "");
}

TEST(JpegDamage, large_pictures_must_be_whole)
{
    // Memory for 2^24 pixels and more is only taken for files that have them.
    const CodeImage large{4104, 4104, 3, 8, Bytes(std::size_t{4104} * 4104 * 3, 77)};
    Bytes file = encode_jpeg(large, {75, true});
    file.resize(file.size() * 9 / 10);
    expect_refused(decode_all_the_same, file, "before its end marker");
}

TEST(JpegDamage, scans_beyond_reason_are_refused_while_they_are_read)
{
    // The first scan's data hides the beginning of others from those who only look for markers.
    Bytes file = start_of_image + table_segments() + frame(8, 8, 0xc2);
    for (int i = 0; i < 101; ++i)
        file = file + Bytes{0xff, 0xda, 0, 8, 1, 1, 0, 0, 0, 0, 0b01000111};
    expect_refused(decode_all_the_same, file + end_of_image, "101 scans");
}

TEST(JpegDamage, mutations)
{
    for (const Bytes& valid :
         {tiny_jpeg(), encode(20, 10, {TJPF_RGB, TJSAMP_420, 0}),
          encode(20, 10, {TJPF_RGB, TJSAMP_444, TJFLAG_PROGRESSIVE}), encode_sampled(33, 17, {4, 2})})
        expect_mutations_survived(decode_all_the_same, valid, 3000);
}

} // namespace
} // namespace lambent::image
