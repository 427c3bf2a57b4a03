// Radiance files that lie, end early or were tampered with.
#include "image/radiance/radiance_hdr.h"
#include "tests/image/hostile.h"
#include "tests/image/radiance_writer.h"

#include <gtest/gtest.h>

namespace lambent::image {
namespace {

using namespace lambent::test;

void decode(std::span<const std::uint8_t> bytes, const std::string& name)
{
    const auto reader = open_radiance_hdr(open_bytes(bytes, name));
    std::vector<float> row(static_cast<std::size_t>(reader->width()) * 3);
    for (int y = 0; y < reader->height(); ++y)
        reader->read_rows(1, row.data());
}

Bytes small_file(bool planes, const std::string& resolution)
{
    Bytes bytes = radiance_header(resolution);
    for (unsigned y = 0; y < 5; ++y)
        bytes = bytes + (planes ? plane_scanline(mixed_pixels(20, y)) : repeat_scanline(mixed_pixels(20, y)));
    return bytes;
}

TEST(RadianceBad, header)
{
    struct Case {
        const char* bytes;
        const char* reason;
    };
    for (const Case& bad : {
             Case{"", "ends in the middle of its header"},
             Case{"just some text\n", "not a Radiance picture"},
             Case{"\x89PNG\r\n\x1a\n", "not a Radiance picture"},
             Case{"#?RADIANCE", "ends in the middle of its header"},
             Case{"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n", "ends in the middle of its header"},
             Case{"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n....", "32-bit_rle_xyze"},
             Case{"#?RADIANCE\nFORMAT=16-bit\n\n-Y 1 +X 1\n....", "16-bit"},
             Case{"#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\n....", "EXPOSURE=0"},
             Case{"#?RADIANCE\nEXPOSURE=-1\n\n-Y 1 +X 1\n....", "EXPOSURE=-1"},
             Case{"#?RADIANCE\nEXPOSURE=nan\n\n-Y 1 +X 1\n....", "EXPOSURE=nan"},
             Case{"#?RADIANCE\nEXPOSURE=inf\n\n-Y 1 +X 1\n....", "exposure of inf"},
             Case{"#?RADIANCE\nEXPOSURE=1e25\nEXPOSURE=1e25\n\n-Y 1 +X 1\n....", "exposure of 1e+50"},
             Case{"#?RADIANCE\nEXPOSURE=much\n\n-Y 1 +X 1\n....", "EXPOSURE=much"},
             Case{"#?RADIANCE\nCOLORCORR=1 2\n\n-Y 1 +X 1\n....", "COLORCORR=1 2"},
             Case{"#?RADIANCE\n\n-Y 1 +X 0\n....", "not positive"},
             Case{"#?RADIANCE\n\n-Y -5 +X 4\n....", "not positive"},
             Case{"#?RADIANCE\n\n-Y 200000 +X 100000\n....", "above the limit"},
             Case{"#?RADIANCE\n\n-Y 65536 +X 65536\n....", "above the limit"},
             Case{"#?RADIANCE\n\n-Y 99999999999999999999 +X 4\n....", "resolution line"},
             Case{"#?RADIANCE\n\n-Y 4 -Y 4\n....", "resolution line"},
             Case{"#?RADIANCE\n\n-Y 4\n....", "resolution line"},
             Case{"#?RADIANCE\n\n4 4\n....", "resolution line"},
             Case{"#?RADIANCE\n\n-Y 1 +X 1 1\n....", "resolution line"},
             Case{"#?RADIANCE\n\n-Y 16384 +X 16384\n....", "cannot hold"},
             Case{"#?RADIANCE\n\n+X 16384 +Y 16384\n....", "cannot hold"},
         })
        expect_refused(decode, bytes_of(bad.bytes), bad.reason);
    expect_refused(decode, bytes_of("#?RADIANCE\n" + std::string(1 << 20, 'x')), "does not end");
}

TEST(RadianceBad, scanlines)
{
    struct Case {
        Bytes body;
        const char* reason;
    };
    const Bytes fine_plane = {128 + 10, 7};
    for (const Case& bad : {
             Case{{2, 2, 0, 11, 128 + 10, 7, 0, 0}, "11 pixels long instead of 10"},
             Case{{2, 2, 0, 10, 128 + 11, 7, 0, 0}, "goes beyond its end"},
             Case{{2, 2, 0, 10, 255, 7, 0, 0}, "goes beyond its end"},
             Case{{2, 2, 0, 10, 128 + 9, 7, 2, 1, 1, 0}, "goes beyond its end"},
             Case{{2, 2, 0, 10, 0, 0, 0, 0, 0, 0}, "packet of zero bytes"},
             Case{{1, 1, 1, 5, 0, 0, 0, 0}, "before the first pixel"},
             Case{{9, 9, 200, 128, 1, 1, 1, 10}, "goes beyond its end"},
             Case{{9, 9, 200, 128, 1, 1, 1, 0, 1, 1, 1, 1}, "goes beyond its end"},
             Case{{9, 9, 200, 128, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0}, "more than three"},
             Case{Bytes{2, 2, 0, 10} + fine_plane + fine_plane + fine_plane, "ends in scanline 0"},
         })
        expect_refused(decode, radiance_header("-Y 1 +X 10") + bad.body, bad.reason);
}

TEST(RadianceBad, names_the_scanline)
{
    const Bytes bytes = radiance_header("-Y 3 +X 2") + Bytes(16, 200) + Bytes{1, 1, 1, 1, 0, 0, 0, 0};
    expect_refused(decode, bytes, "scanline 2: ");
}

TEST(RadianceBad, every_truncation)
{
    expect_truncations_refused(decode, small_file(true, "-Y 5 +X 20"));
    expect_truncations_refused(decode, small_file(false, "-Y 5 +X 20"));
    expect_truncations_refused(decode, small_file(true, "+X 5 +Y 20"));
}

TEST(RadianceBad, mutations)
{
    expect_mutations_survived(decode, small_file(true, "-Y 5 +X 20"), 4000);
    expect_mutations_survived(decode, small_file(false, "-Y 5 +X 20"), 4000);
    expect_mutations_survived(decode, small_file(true, "-X 5 +Y 20"), 2000);
}

} // namespace
} // namespace lambent::image
