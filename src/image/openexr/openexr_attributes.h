// The attributes of OpenEXR headers that are used, and the values of those that are read.
#pragma once

#include "image/byte_source.h"
#include "image/openexr/openexr_part.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace lambent::image {

/// An attribute that this program or the library uses.
struct ExrAttribute {
    enum class Need {
        required, ///< refused if it is missing or malformed
        checked,  ///< refused if it is malformed
        optional, ///< ignored if it is malformed or its value is invalid
    };

    std::string_view name;
    std::string_view type;
    std::uint32_t size; ///< of its value in bytes; 0: any
    Need need = Need::checked;
};

/// All such attributes.
std::span<const ExrAttribute> exr_attributes();

/// The one with a name; null for other names.
const ExrAttribute* find_exr_attribute(std::string_view name);

/// Reads the value of an attribute that is not optional into `part`. `value` has the attribute's size. Throws
/// Error(bad_input) for values that are invalid or do not fit the file.
void read_exr_attribute(const ExrAttribute& attribute, std::span<std::uint8_t> value,
                        const ByteSource& source, ExrPart& part);

/// Reads the value of an optional attribute into `part`. Returns false for invalid values.
bool read_optional_exr_attribute(const ExrAttribute& attribute, std::span<const std::uint8_t> value,
                                 ExrPart& part);

} // namespace lambent::image
