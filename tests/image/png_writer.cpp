#include "tests/image/png_writer.h"

#include <algorithm>

namespace lambent::test {
namespace {

Bytes big_endian(std::uint32_t word)
{
    return {static_cast<std::uint8_t>(word >> 24), static_cast<std::uint8_t>(word >> 16),
            static_cast<std::uint8_t>(word >> 8), static_cast<std::uint8_t>(word)};
}

// Bit by bit, polynomial 0xedb88320.
std::uint32_t crc32(const Bytes& bytes)
{
    std::uint32_t crc = 0xffffffffu;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

std::uint32_t adler32(const Bytes& bytes)
{
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

} // namespace

Bytes png_chunk(const std::string& type, const Bytes& content)
{
    const Bytes checked = bytes_of(type) + content;
    return big_endian(static_cast<std::uint32_t>(content.size())) + checked + big_endian(crc32(checked));
}

Bytes stored_zlib(const Bytes& content)
{
    Bytes stream = {0x78, 0x01};
    std::size_t at = 0;
    do {
        const std::size_t count = std::min<std::size_t>(content.size() - at, 65535);
        const bool last = at + count == content.size();
        const auto low = static_cast<std::uint8_t>(count), high = static_cast<std::uint8_t>(count >> 8);
        stream = stream +
                 Bytes{last, low, high, static_cast<std::uint8_t>(~low), static_cast<std::uint8_t>(~high)};
        const auto begin = content.begin() + static_cast<std::ptrdiff_t>(at);
        stream.insert(stream.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
        at += count;
    } while (at < content.size());
    return stream + big_endian(adler32(content));
}

Bytes png_start(const PngShape& shape)
{
    return Bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'} +
           png_chunk("IHDR", big_endian(shape.width) + big_endian(shape.height) +
                                 Bytes{shape.depth, shape.colour, 0, 0, shape.interlace});
}

Bytes png_file(const PngShape& shape, const Bytes& rows, const Bytes& between)
{
    return png_start(shape) + between + png_chunk("IDAT", stored_zlib(rows)) + png_chunk("IEND", {});
}

} // namespace lambent::test
