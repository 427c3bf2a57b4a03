// The headers of an OpenEXR file, read with suspicion before the library sees them ("OpenEXR File Layout").
#pragma once

#include "image/byte_source.h"
#include "image/openexr/openexr_part.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambent::image {

struct ExrHeader {
    std::vector<ExrPart> parts;
    /// The start of the file up to the end of the headers. Attributes that do not matter here have their
    /// type renamed to one that no library knows, so that none tries to understand them.
    std::vector<std::uint8_t> bytes;
};

/// Whether the bytes begin as an OpenEXR file does.
bool is_exr(std::span<const std::uint8_t> bytes);

/// Checks what a library would allocate memory for: every length against the file, every size against the
/// limits, the number of chunks against the room for their table. Throws Error(bad_input).
ExrHeader read_exr_header(ByteSource& source);

} // namespace lambent::image
