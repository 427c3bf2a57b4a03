// Notes in files: where each format's specification puts them, and nothing else changed.
#include "image/files/image_io.h"
#include "image/codes/jpeg.h"
#include "image/codes/png.h"
#include "image/openexr/openexr.h"
#include "image/radiance/radiance_hdr.h"
#include "tests/image/png_writer.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lambent::image {
namespace {

using namespace lambent::test;

const Notes notes = {{"lambent.error", "0.031 0.027 0.036"}, {"other", "b"}};

CodeImage codes_with_notes()
{
    return {5, 3, 3, 8, std::vector<std::uint8_t>(45, 90)};
}

RadianceImage light_with_notes()
{
    return {12, 3, 4, std::vector<float>(144, 0.5f)};
}

// Where `part` begins in `whole`; a failure if it is not there exactly once.
std::size_t place_of(const Bytes& part, const Bytes& whole)
{
    const auto found = std::search(whole.begin(), whole.end(), part.begin(), part.end());
    EXPECT_NE(found, whole.end());
    if (found != whole.end()) {
        EXPECT_EQ(std::search(found + 1, whole.end(), part.begin(), part.end()), whole.end());
    }
    return static_cast<std::size_t>(found - whole.begin());
}

// Whether both parts are in the file in this order, and the file without them is the plain one.
void expect_inserted(const Bytes& first, const Bytes& second, const Bytes& file, const Bytes& plain)
{
    const std::size_t at = place_of(first, file);
    ASSERT_EQ(place_of(second, file), at + first.size());
    Bytes rest = file;
    const auto begin = rest.begin() + static_cast<std::ptrdiff_t>(at);
    rest.erase(begin, begin + static_cast<std::ptrdiff_t>(first.size() + second.size()));
    EXPECT_EQ(rest, plain);
}

const Bytes zero = {0};

// ISO/IEC 15948, 11.3.4.3: keyword, zero, text; with a checksum that is not libspng's.
TEST(Notes, png_has_a_text_chunk_for_each)
{
    const Bytes file = encode_png(codes_with_notes(), {}, notes);
    expect_inserted(png_chunk("tEXt", bytes_of("lambent.error") + zero + bytes_of("0.031 0.027 0.036")),
                    png_chunk("tEXt", bytes_of("other") + zero + bytes_of("b")), file,
                    encode_png(codes_with_notes()));
    EXPECT_EQ(decode_png(file, "test.png").bytes[0], 90);
}

// ITU-T T.81, B.2.4.5: marker, length with its own two bytes, text; after JFIF's header, 16 bytes and a marker long.
TEST(Notes, jpeg_has_a_comment_for_each)
{
    const Bytes file = encode_jpeg(codes_with_notes(), {}, notes);
    const std::string comment = "lambent.error: 0.031 0.027 0.036";
    expect_inserted(Bytes{0xff, 0xfe, 0, static_cast<std::uint8_t>(comment.size() + 2)} + bytes_of(comment),
                    Bytes{0xff, 0xfe, 0, 10} + bytes_of("other: b"), file, encode_jpeg(codes_with_notes()));
    EXPECT_EQ(place_of(bytes_of(comment), file), 2u + 18u + 4u);
    EXPECT_NEAR(decode_jpeg(file, "test.jpg").bytes[0], 90, 2);
    EXPECT_EQ(inspect_jpeg(file, "test.jpg").width, 5);
}

TEST(Notes, a_comment_of_jpeg_ends_where_its_length_does)
{
    const Bytes file = encode_jpeg(codes_with_notes(), {}, {{"k", std::string(70000, 'x')}});
    EXPECT_EQ(place_of(Bytes{0xff, 0xfe, 0xff, 0xff} + bytes_of("k: x"), file), 20u);
    EXPECT_EQ(decode_jpeg(file, "test.jpg").width, 5);
}

// "OpenEXR file layout": name, zero, type, zero, size in four bytes, value.
TEST(Notes, exr_has_an_attribute_for_each)
{
    const Bytes file = encode_exr(light_with_notes(), notes);
    place_of(bytes_of("lambent.error") + zero + bytes_of("string") + zero + Bytes{17, 0, 0, 0} +
                 bytes_of("0.031 0.027 0.036"),
             file);
    place_of(bytes_of("other") + zero + bytes_of("string") + zero + Bytes{1, 0, 0, 0} + bytes_of("b"), file);
    EXPECT_EQ(decode_radiance(file, "test.exr").values, std::vector<float>(108, 0.5f));
}

TEST(Notes, hdr_has_a_comment_line_for_each)
{
    const Bytes file = encode_radiance_hdr(light_with_notes(), notes);
    expect_inserted(bytes_of("# lambent.error: 0.031 0.027 0.036\n"), bytes_of("# other: b\n"), file,
                    encode_radiance_hdr(light_with_notes()));
    EXPECT_EQ(decode_radiance(file, "test.hdr").values, std::vector<float>(108, 0.5f));
}

} // namespace
} // namespace lambent::image
