// OpenEXR files, read and written with the OpenEXR library.
#pragma once

#include "image/byte_source.h"
#include "image/image.h"
#include "image/notes.h"
#include "image/reader.h"
#include "image/openexr/openexr_header.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace lambent::image {

/// Reads the rows of the first part that has colour: channels R, G, B; else those of the first layer that has all
/// three; else luminance-chroma (Y, RY, BY with half the resolution in each direction, in the first part, through half
/// floats); else Y as grey. Supports half, float and uint, scanlines and tiles (their finest level), and every
/// compression. The image is the display window, or the data window of an environment map (attribute `envmap`). It is
/// black where the data window has no pixels; pixels outside the display window are left out. Colours are converted to
/// Rec. 709 by the attribute `chromaticities`; `whiteLuminance` is not applied. Deep images and other subsampled
/// channels are refused. Rows are decoded in groups (1 to 256 rows, or those of a tile): calls for many rows at once
/// use several threads. Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_exr(std::unique_ptr<ByteSource> source);

/// Reads the alpha channel of the same part and layer instead, as grey; null if there is none. Throws Error(bad_input).
std::unique_ptr<RadianceReader> open_exr_alpha(std::unique_ptr<ByteSource> source);

/// Format and size of an OpenEXR file. Throws Error(bad_input).
ImageInfo inspect_exr(ByteSource& source);

/// Encodes RGB or RGBA as 32-bit floats with ZIP compression. Every value is kept, NaN and infinity included. Each note
/// becomes an attribute of type string.
std::vector<std::uint8_t> encode_exr(const RadianceImage& image, const Notes& notes = {});

/// Encodes RGB or RGBA as half floats with DWAB compression: at most a tenth of the size of encode_exr(), with errors
/// like those of a JPEG. `loss` is the library's compression level, 45 its default.
std::vector<std::uint8_t> encode_small_exr(const RadianceImage& image, float loss = 45.0f);

} // namespace lambent::image
