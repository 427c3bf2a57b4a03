// JPEG (ITU-T T.81), read with libjpeg's API and written with TurboJPEG's.
#pragma once

#include "image/image.h"
#include "image/notes.h"
#include "image/reader.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lambent::image {

/// The largest width and height that libjpeg writes.
inline constexpr int max_jpeg_side = 65500;

/// Whether the bytes begin with JPEG's signature.
bool is_jpeg(std::span<const std::uint8_t> bytes);

/// Decodes an 8-bit grey, YCbCr or RGB JPEG, of any subsampling that libjpeg supports, to RGBA with alpha 255. Refuses
/// CMYK and YCCK files, whose colours depend on the profile of a printing press, and files with more scans than any
/// legitimate encoder makes.
/// A file that the decoder warns of (stray bytes, an early end) is decoded as far as possible, grey or smeared beyond,
/// with one line in `warnings`. Without `warnings`, or with more than 2^24 pixels and an early end, it is refused.
/// Throws Error(bad_input).
CodeImage decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name,
                      Warnings* warnings = nullptr);

/// Format and size of a JPEG. An early end is a warning; without `warnings` the file is refused. Throws
/// Error(bad_input).
ImageInfo inspect_jpeg(std::span<const std::uint8_t> bytes, const std::string& name,
                       Warnings* warnings = nullptr);

/// Quality against size and speed in encode_jpeg. The default suits images that are stored.
struct JpegEffort {
    int quality = 95;    ///< 1 to 100
    bool halved = false; ///< 4:2:0 chroma subsampling and a faster DCT
};

/// Encodes a valid 8-bit image; alpha is dropped. Each note becomes a comment, "key: value", cut off after 65533
/// characters. Throws std::bad_alloc only.
std::vector<std::uint8_t> encode_jpeg(const CodeImage& image, const JpegEffort& effort = {},
                                      const Notes& notes = {});

} // namespace lambent::image
