// Reads and checks the headers of an OpenEXR file before the library does ("OpenEXR File Layout").
#pragma once

#include "image/byte_source.h"
#include "image/openexr/openexr_part.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambent::image {

struct ExrHeader {
    std::vector<ExrPart> parts;
    /// The file up to the end of the headers. The types of attributes that are not used are renamed to unknown
    /// ones, so that the library does not parse them.
    std::vector<std::uint8_t> bytes;
};

/// Whether the bytes begin with OpenEXR's signature.
bool is_exr(std::span<const std::uint8_t> bytes);

/// Reads the headers and checks everything that the library allocates memory for: lengths and the number of chunks
/// against the size of the file, image and tile sizes against the limits. Throws Error(bad_input).
ExrHeader read_exr_header(ByteSource& source);

} // namespace lambent::image
