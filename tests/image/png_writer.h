// PNG files made by hand after ISO/IEC 15948: stored deflate blocks, own checksums, any chunk.
#pragma once

#include "tests/image/bytes.h"

#include <cstdint>
#include <string>

namespace lambent::test {

struct PngShape {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint8_t depth = 8;
    std::uint8_t colour = 2; ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    std::uint8_t interlace = 0;
};

/// Length, type, content, CRC-32.
Bytes png_chunk(const std::string& type, const Bytes& content);

/// zlib stream of stored blocks with its Adler-32.
Bytes stored_zlib(const Bytes& content);

/// Signature and IHDR.
Bytes png_start(const PngShape& shape);

/// A whole file: `rows` are the scanlines with their filter bytes; `between` are chunks before the pixels.
Bytes png_file(const PngShape& shape, const Bytes& rows, const Bytes& between = {});

} // namespace lambent::test
