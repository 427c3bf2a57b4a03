// Reads JSON into structs by tables, and leaves out what does not fit them.
#pragma once

#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf_document/gltf_table.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>

namespace lambent::scene {

/// Who hears of what does not fit.
struct ReadNotes {
    const std::string& file;
    Losses& losses;
    std::uint64_t most_bytes = 0; ///< that the structs of all lists together may take
};

/// Fills `object`, the struct that the shape is of, and uses the document up. A member that does not fit is left as it is,
/// with a warning; where its object needs it, the object is left out, up to the next list, whose element becomes one that
/// is broken. Entries of index lists that do not fit become gltf::unreadable_index. Indices and sizes may be written as
/// fractions (3.0 counts as 3); numbers fit a float.
/// Returns the first loss that may have cost something to draw, as one line, or nothing.
/// Throws Error(bad_input) where the document itself does not fit, for lists of more structs than may be, and for more
/// than 10 000 elements that do not fit.
std::string read_document(nlohmann::json& document, const Shape& shape, void* object, const ReadNotes& notes);

} // namespace lambent::scene
