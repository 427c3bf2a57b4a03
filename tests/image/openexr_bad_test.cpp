// OpenEXR files that lie, end early or were tampered with.
#include "image/openexr/openexr.h"
#include "tests/image/exr_files.h"
#include "tests/image/hostile.h"

#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfPartType.h>
#include <ImfPreviewImage.h>
#include <ImfStandardAttributes.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace lambent::image {
namespace {

using namespace lambent::test;

void decode(std::span<const std::uint8_t> bytes, const std::string& name)
{
    const auto reader = open_exr(open_bytes(bytes, name));
    std::vector<float> row(static_cast<std::size_t>(reader->width()) * 3);
    for (int y = 0; y < reader->height(); ++y)
        reader->read_rows(1, row.data());
}

// Where the value of an attribute starts: behind its name, its type and four bytes of size.
std::size_t value_of(const Bytes& bytes, const std::string& name, const std::string& type)
{
    const std::string key = name + '\0' + type + '\0';
    const auto found = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
    EXPECT_NE(found, bytes.end()) << name;
    return static_cast<std::size_t>(found - bytes.begin()) + key.size() + 4;
}

void put(Bytes& bytes, std::size_t at, std::int64_t word)
{
    for (std::size_t i = 0; i < 4; ++i)
        bytes[at + i] = static_cast<std::uint8_t>(word >> 8 * i);
}

Bytes with_window(int min_x, int min_y, std::int64_t max_x, std::int64_t max_y,
                  const char* which = "dataWindow")
{
    Bytes bytes = make_exr({});
    const std::size_t at = value_of(bytes, which, "box2i");
    put(bytes, at, min_x);
    put(bytes, at + 4, min_y);
    put(bytes, at + 8, max_x);
    put(bytes, at + 12, max_y);
    return bytes;
}

Bytes shown_in(int min_x, int min_y, std::int64_t max_x, std::int64_t max_y)
{
    return with_window(min_x, min_y, max_x, max_y, "displayWindow");
}

Bytes with_word(const Bytes& file, const std::string& name, const std::string& type, std::int64_t offset,
                std::int64_t word)
{
    Bytes bytes = file;
    put(bytes, static_cast<std::size_t>(static_cast<std::int64_t>(value_of(bytes, name, type)) + offset),
        word);
    return bytes;
}

Bytes deep()
{
    const TemporaryFolder folder;
    const std::string path = (folder / "deep.exr").string();
    {
        Imf::Header header(2, 2);
        header.setType(Imf::DEEPSCANLINE);
        header.compression() = Imf::ZIPS_COMPRESSION;
        for (const char* channel : {"R", "G", "B"})
            header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
        Imf::DeepScanLineOutputFile file(path.c_str(), header);
        unsigned counts[4] = {1, 1, 1, 1};
        float value = 1;
        float* pointers[4] = {&value, &value, &value, &value};
        Imf::DeepFrameBuffer frame;
        frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts), 4, 8));
        for (const char* channel : {"R", "G", "B"})
            frame.insert(channel, Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers), 8, 16, 4));
        file.setFrameBuffer(frame);
        file.writePixels(2);
    }
    return content_of(path);
}

TEST(OpenExrBad, headers)
{
    const Bytes plain = make_exr({});
    const Bytes tiled = make_exr({.tile = 4});
    Bytes wrong_magic = plain, wrong_version = plain;
    wrong_magic[0] ^= 1;
    wrong_version[4] = 3;
    Bytes wrong_compression = plain;
    wrong_compression[value_of(plain, "compression", "compression")] = 42;
    Bytes two_types = plain;
    two_types[value_of(plain, "dataWindow", "box2i") - 6] = 'x';
    struct Case {
        Bytes bytes;
        const char* reason;
    };
    for (const Case& bad : {
             Case{{}, "ends in the middle of its header"},
             Case{bytes_of("just some text"), "not an OpenEXR file"},
             Case{wrong_magic, "not an OpenEXR file"},
             Case{wrong_version, "version"},
             Case{wrong_compression, "compression 42"},
             Case{two_types, "dataWindow"},
             Case{with_window(0, 0, 199999, 99999), "above the limit"},
             Case{with_window(0, 0, 16383, 16383), "cannot hold"},
             Case{with_window(0, 0, 65535, 10), "cannot hold"},
             Case{with_window(0, 0, -1, 7), "not positive"},
             Case{with_window(0, 0, 7, -5), "not positive"},
             Case{with_window(-2147483647 - 1, 0, 2147483647, 7), "above the limit"},
             Case{with_window(-2147483647 - 1, 0, -2147483641, 7), "too far"},
             Case{with_word(plain, "dataWindow", "box2i", -4, 2147483647), "dataWindow"},
             Case{with_word(plain, "channels", "chlist", -4, 1000000), "channels"},
             Case{with_word(plain, "channels", "chlist", -4, 30), "list of channels"},
             Case{with_word(plain, "channels", "chlist", 2, 77), "channel B"},
             Case{with_word(plain, "channels", "chlist", 10, 0), "channel B"},
             Case{with_word(tiled, "tiles", "tiledesc", 0, 0), "not positive"},
             Case{with_word(tiled, "tiles", "tiledesc", 0, 1 << 30), "above the limit"},
             Case{with_word(with_word(tiled, "tiles", "tiledesc", 0, 65536), "tiles", "tiledesc", 4, 4096),
                  "cannot hold"},
             Case{make_exr({.channels = {"A", "Z", "left.R"}}), "A, Z, left.R"},
             Case{shown_in(0, 0, 39999, 39999), "above the limit"},
             Case{shown_in(0, 0, 9999, 9999), "far larger than the 8x8"},
             Case{shown_in(0, 0, -1, 7), "not positive"},
             Case{shown_in(-2147483647 - 1, 0, -2147483641, 7), "too far"},
             Case{shown_in(8, 0, 15, 7), "outside its display window"},
             Case{shown_in(0, -4, 7, -1), "outside its display window"},
             Case{deep(), "deep"},
         })
        expect_refused(decode, bad.bytes, bad.reason);
}

TEST(OpenExrBad, subsampled_channels)
{
    const TemporaryFolder folder;
    const std::string path = (folder / "sub.exr").string();
    {
        Imf::Header header(8, 8);
        std::vector<float> values(64);
        Imf::FrameBuffer frame;
        for (const char* channel : {"R", "G", "B"}) {
            const int step = *channel == 'B' ? 2 : 1;
            header.channels().insert(channel, Imf::Channel(Imf::FLOAT, step, step));
            frame.insert(channel,
                         Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 32, step, step));
        }
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(8);
    }
    expect_refused(decode, content_of(path), "channel B is subsampled");
}

// Attributes that the library would unpack or allocate for are hidden from it, and must not matter.
TEST(OpenExrBad, harmless_metadata_stays_harmless)
{
    const TemporaryFolder folder;
    const std::string path = (folder / "owner.exr").string();
    {
        Imf::Header header(8, 8);
        Imf::addOwner(header, "somebody");
        header.setPreviewImage(Imf::PreviewImage(4, 4));
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
        std::vector<float> values(64, 2.5f);
        Imf::FrameBuffer frame;
        frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 32));
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(8);
    }
    Bytes bytes = content_of(path);
    EXPECT_NO_THROW(decode(bytes, "test.exr"));
    // A preview of 30000x30000, in 64 bytes.
    put(bytes, value_of(bytes, "preview", "preview"), 30000);
    put(bytes, value_of(bytes, "preview", "preview") + 4, 30000);
    EXPECT_NO_THROW(decode(bytes, "test.exr"));
}

TEST(OpenExrBad, every_truncation)
{
    expect_truncations_refused(decode, make_exr({}));
    expect_truncations_refused(decode, make_exr({.type = Imf::HALF, .compression = Imf::NO_COMPRESSION}));
    expect_truncations_refused(decode, make_exr({.tile = 4}));
}

TEST(OpenExrBad, mutations)
{
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
          Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION,
          Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
        SCOPED_TRACE(compression);
        expect_mutations_survived(decode, make_exr({.type = Imf::HALF, .compression = compression}), 500);
        expect_mutations_survived(decode,
                                  make_exr({.type = Imf::HALF, .compression = compression, .tile = 4}), 500);
    }
}

} // namespace
} // namespace lambent::image
