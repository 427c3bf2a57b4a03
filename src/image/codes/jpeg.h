// JPEG (ITU-T T.81), read through libjpeg's API, written through TurboJPEG's.
#pragma once

#include "image/image.h"
#include "image/reader.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lambent::image {

/// The largest side that libjpeg writes.
inline constexpr int max_jpeg_side = 65500;

/// Whether the bytes begin as a JPEG does.
bool is_jpeg(std::span<const std::uint8_t> bytes);

/// An 8-bit grey, YCbCr or RGB JPEG as RGBA with alpha 255, of any subsampling that libjpeg decodes. CMYK and YCCK files
/// are refused: to show them needs the colour profile of a press. So are files with more scans than any honest encoder
/// makes.
/// A file about which the decoder complains (stray bytes, an early end) is read as far as it goes, grey or smeared
/// beyond, with one line in `warnings`; without `warnings`, and where it has more than 2^24 pixels and ends early, it is
/// refused.
/// Throws Error(bad_input).
CodeImage decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name,
                      Warnings* warnings = nullptr);

/// An early end is a warning, or without `warnings` refused. Throws Error(bad_input).
ImageInfo inspect_jpeg(std::span<const std::uint8_t> bytes, const std::string& name,
                       Warnings* warnings = nullptr);

/// The trade of looks against size of encode_jpeg. The default is for pictures to keep.
struct JpegEffort {
    int quality = 95;    ///< 1 to 100
    bool halved = false; ///< half as many places for colour across and down, and faster arithmetic
};

/// A valid 8-bit image as a JPEG; alpha is dropped. Throws std::bad_alloc only.
std::vector<std::uint8_t> encode_jpeg(const CodeImage& image, const JpegEffort& effort = {});

} // namespace lambent::image
