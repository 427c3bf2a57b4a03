// OpenEXR files, through the OpenEXR library.
#pragma once

#include "image/byte_source.h"
#include "image/image.h"
#include "image/reader.h"
#include "image/openexr/openexr_header.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace lambent::image {

/// The rows of the first part that has colour: channels R, G, B; else those of the first layer that has all
/// three; else luminance-chroma (Y, RY, BY with half the resolution each way, the first part, through half floats); else Y
/// as grey. Half, float and uint, scanlines and tiles (their finest level), every compression.
/// The display window is the image: black where the data window has no pixels, and what that has beyond is left out. Of
/// environment maps (attribute `envmap`) the data window is. Colours are converted to Rec. 709 by the attribute
/// `chromaticities`; `whiteLuminance` is not applied. Deep images and other subsampled channels are refused.
/// Rows are decoded in groups (1 to 256 rows, or those of a tile): calls for many rows at once use several
/// threads. Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_exr(std::unique_ptr<ByteSource> source);

/// Throws Error(bad_input).
ImageInfo inspect_exr(ByteSource& source);

/// RGB or RGBA, 32-bit float, ZIP, every value as it is, NaN and infinity included.
std::vector<std::uint8_t> encode_exr(const RadianceImage& image);

/// RGB or RGBA, half floats, DWAB: a tenth of the size or less, at errors like a JPEG's. `loss` is the library's
/// compression level; 45 is its own choice.
std::vector<std::uint8_t> encode_small_exr(const RadianceImage& image, float loss = 45.0f);

} // namespace lambent::image
