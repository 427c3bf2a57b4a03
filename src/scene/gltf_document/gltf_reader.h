// Reading of JSON into structs by schema tables. Values that do not fit the tables are left out.
#pragma once

#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf_document/gltf_table.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>

namespace lambent::scene {

/// The file's name for messages, the receiver of warnings, and the limit of memory.
struct ReadNotes {
    const std::string& file;
    Losses& losses;
    std::uint64_t most_bytes = 0; ///< limit of the structs of all lists together
};

/// Fills `object`, the struct that the shape describes, and consumes the document. A member that does not fit keeps
/// its default, with a warning. If it is required, the object that holds it is left out, and so on outwards up to an
/// element of a list, which is marked as broken. Entries of index lists that do not fit become gltf::unreadable_index.
/// Indices and sizes may be written as fractions (3.0 counts as 3); numbers must be in the range of floats. Returns
/// the message of the first fault that may have cost geometry, or an empty string. Throws Error(bad_input) if the
/// document itself does not fit, if its lists exceed the limit of memory, and for more than 10 000 broken elements.
std::string read_document(nlohmann::json& document, const Shape& shape, void* object, const ReadNotes& notes);

} // namespace lambent::scene
