#include "tests/scene/png_writer.h"

#include <span>
#include <string_view>

namespace lambent::scene::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append_big_endian(Bytes& bytes, std::uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

// ISO/IEC 15948, annex D, bit by bit.
std::uint32_t crc(std::span<const std::uint8_t> bytes)
{
    std::uint32_t remainder = 0xFFFFFFFFu;
    for (const std::uint8_t byte : bytes) {
        remainder ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            remainder = remainder & 1u ? 0xEDB88320u ^ remainder >> 1 : remainder >> 1;
    }
    return ~remainder;
}

void append_chunk(Bytes& png, std::string_view kind, const Bytes& data)
{
    append_big_endian(png, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = png.size();
    png.insert(png.end(), kind.begin(), kind.end());
    png.insert(png.end(), data.begin(), data.end());
    append_big_endian(png, crc(std::span(png).subspan(start)));
}

Bytes rows_of(const Pixels& pixels)
{
    Bytes rows;
    for (std::size_t i = 0; i < pixels.values.size(); ++i) {
        if (i % (4 * pixels.width) == 0)
            rows.push_back(0); // filter: none
        if (pixels.bits == 16)
            rows.push_back(static_cast<std::uint8_t>(pixels.values[i] >> 8));
        rows.push_back(static_cast<std::uint8_t>(pixels.values[i]));
    }
    return rows;
}

Bytes stored_zlib(const Bytes& data)
{
    const auto size = static_cast<std::uint16_t>(data.size());
    const auto inverse = static_cast<std::uint16_t>(~size);
    Bytes stream = {0x78,
                    0x01,
                    0x01,
                    static_cast<std::uint8_t>(size),
                    static_cast<std::uint8_t>(size >> 8),
                    static_cast<std::uint8_t>(inverse),
                    static_cast<std::uint8_t>(inverse >> 8)};
    stream.insert(stream.end(), data.begin(), data.end());
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::uint8_t byte : data) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    append_big_endian(stream, b << 16 | a);
    return stream;
}

} // namespace

Bytes make_png(const Pixels& pixels)
{
    Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    Bytes header;
    append_big_endian(header, pixels.width);
    append_big_endian(header, pixels.height);
    for (const int value : {pixels.bits, 6, 0, 0, 0}) // RGBA, deflate, adaptive filters, not interlaced
        header.push_back(static_cast<std::uint8_t>(value));
    append_chunk(png, "IHDR", header);
    append_chunk(png, "IDAT", stored_zlib(rows_of(pixels)));
    append_chunk(png, "IEND", {});
    return png;
}

} // namespace lambent::scene::test
