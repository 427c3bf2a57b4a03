// Radiance .hdr files: own code, because environments come in them and must load at the speed of memory.
#pragma once

#include "image/byte_source.h"
#include "image/image.h"
#include "image/reader.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace lambent::image {

/// The rows of a Radiance picture as radiance (stored values divided by EXPOSURE and COLORCORR). All three
/// scanline encodings, mixed at will. Holds some two megabytes when rows are stored top to bottom and left
/// to right; in each of the seven other orders the whole picture in 4 bytes a pixel. Calls for many rows are
/// spread over threads. Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_radiance_hdr(std::unique_ptr<ByteSource> source);

/// Throws Error(bad_input).
ImageInfo inspect_radiance_hdr(ByteSource& source);

/// The nearest RGBE codes of each pixel, run length coded, rows from the top. Coverage is dropped.
std::vector<std::uint8_t> encode_radiance_hdr(const RadianceImage& image);

} // namespace lambent::image
