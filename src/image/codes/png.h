// PNG (ISO/IEC 15948), read and written with libspng.
#pragma once

#include "image/image.h"
#include "image/notes.h"
#include "image/reader.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lambent::image {

/// Whether the bytes begin with PNG's signature.
bool is_png(std::span<const std::uint8_t> bytes);

/// Decodes any PNG to RGBA: grey is expanded, palettes are looked up, tRNS becomes alpha; 16-bit files stay
/// 16-bit, all others become 8-bit. Codes are as stored: gAMA, sRGB and iCCP chunks are ignored. An index beyond
/// the palette is opaque black.
/// A file with complete pixels but damage elsewhere (a wrong checksum, a broken metadata chunk, a missing IEND)
/// is read with one line in `warnings`; without `warnings` it is refused.
/// Throws Error(bad_input).
CodeImage decode_png(std::span<const std::uint8_t> bytes, const std::string& name,
                     Warnings* warnings = nullptr);

/// Format and size of a PNG. Throws Error(bad_input).
ImageInfo inspect_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// Size against speed in encode_png. The default, differences to the left neighbour compressed by runs only,
/// was chosen with bench/image/write_png: zlib's search for matches takes most of the time and in rendered
/// images finds little more than runs do.
struct PngEffort {
    int level = 1;    ///< zlib compression level, 0 to 9
    int strategy = 3; ///< zlib strategy: 0 default, 1 filtered, 2 Huffman only, 3 runs
    int filters = 16; ///< set of spng_filter_choice: 8 none, 16 left, 32 above, 64 average, 128 Paeth
};

/// Encodes a valid image (8 or 16 bits, 3 or 4 channels); each note becomes a tEXt chunk. Throws std::bad_alloc only.
std::vector<std::uint8_t> encode_png(const CodeImage& image, const PngEffort& effort = {},
                                     const Notes& notes = {});

} // namespace lambent::image
