#include "image/openexr/openexr_part.h"

#include "image/refuse.h"

#include <algorithm>
#include <array>

namespace lambent::image {
namespace {

// Rows per scanline chunk and the largest compression ratio. A byte of deflate decodes to at most 1032 bytes,
// before which PXR24 has dropped a quarter, and DWA all but one of 64 values and half of each; ten bits of PIZ's
// Huffman code repeat a 16-bit value 255 times; a two-byte run of RLE decodes to 128 bytes; B44's ratio is fixed.
struct Compression {
    const char* name;
    int rows;
    std::uint64_t most;
};
constexpr std::array<Compression, exr_compressions> compressions = {{
    {"no compression", 1, 1},
    {"RLE", 1, 64},
    {"ZIPS", 1, 1032},
    {"ZIP", 16, 1032},
    {"PIZ", 32, 512},
    {"PXR24", 16, 2064},
    {"B44", 32, 64},
    {"B44A", 32, 64},
    {"DWAA", 32, 132096},
    {"DWAB", 256, 132096},
}};

const Compression& compression_of(const ExrPart& part)
{
    return compressions[static_cast<std::size_t>(part.compression)];
}

std::uint64_t pieces(int length, int piece)
{
    return static_cast<std::uint64_t>((length - 1) / piece + 1);
}

// Bytes per pixel, as a lower bound: without subsampled channels.
std::uint64_t pixel_bytes(const ExrPart& part)
{
    std::uint64_t bytes = 0;
    for (const ExrChannel& channel : part.channels)
        if (channel.x_sampling == 1 && channel.y_sampling == 1)
            bytes += channel.pixel == ExrPixel::half ? 2 : 4;
    return bytes;
}

} // namespace

int ExrPart::rows_per_chunk() const
{
    return tiled ? tile_height : compression_of(*this).rows;
}

std::uint64_t ExrPart::decoded_chunk_bytes() const
{
    // A tile that extends beyond the image is decoded as a whole.
    const int across = tiled ? std::max(width, tile_width) : width;
    return static_cast<std::uint64_t>(across) * static_cast<std::uint64_t>(rows_per_chunk()) *
           channels.size() * 4;
}

const char* ExrPart::compression_name() const
{
    return compression_of(*this).name;
}

void check_exr_part(const ExrPart& part, std::uint64_t file_bytes, const std::string& name)
{
    // Each chunk takes eight bytes in the table of chunks and at least eight for itself.
    constexpr std::uint64_t chunk_bytes = 16;
    const std::uint64_t columns = part.tiled ? pieces(part.width, part.tile_width) : 1;
    const std::uint64_t chunks = columns * pieces(part.height, part.rows_per_chunk());
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(part.width) * static_cast<std::uint64_t>(part.height);
    const std::uint64_t content = part.deep ? 0 : pixels * pixel_bytes(part) / compression_of(part).most;
    // A decoded chunk must be small, or small in proportion to the file.
    constexpr std::uint64_t modest = std::uint64_t{1} << 26;
    const bool too_large_at_once = part.decoded_chunk_bytes() > std::max(modest, file_bytes * 64);
    if (chunks > file_bytes / chunk_bytes || content > file_bytes || too_large_at_once)
        refuse(name, "a file of ", file_bytes, " bytes cannot hold the ", part.width, "x", part.height,
               " pixels of ", part.channels.size(), " channels its header claims");
}

} // namespace lambent::image
