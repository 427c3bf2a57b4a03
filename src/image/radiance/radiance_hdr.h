// Radiance .hdr files, read by our own code because environments use this format and must load at memory speed.
#pragma once

#include "image/byte_source.h"
#include "image/image.h"
#include "image/notes.h"
#include "image/reader.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace lambent::image {

/// Reads the rows of a Radiance image as radiance (stored values divided by EXPOSURE and COLORCORR), in any
/// mixture of the three scanline encodings. Takes some two megabytes of memory if rows are stored from top to
/// bottom and left to right; in each of the seven other orders, 4 bytes per pixel of the image. Calls for many
/// rows use several threads. Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_radiance_hdr(std::unique_ptr<ByteSource> source);

/// Format and size of a Radiance image. Throws Error(bad_input).
ImageInfo inspect_radiance_hdr(ByteSource& source);

/// Encodes each pixel as the nearest RGBE codes, run-length encoded, rows from the top. Coverage is dropped. Each note
/// becomes a comment line of the header, "# key: value".
std::vector<std::uint8_t> encode_radiance_hdr(const RadianceImage& image, const Notes& notes = {});

} // namespace lambent::image
