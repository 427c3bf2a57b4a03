// The position of a fault in a document.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lambent::scene {

/// One level of a position. Levels form a chain on the stack, which becomes text only for messages; the schema tables,
/// not the file, limit its length.
struct DocumentPosition {
    const DocumentPosition* outer = nullptr;
    std::string_view name;
    std::ptrdiff_t index = -1;
};

/// The message for a fault: "mesh 0, primitive 1: REASON".
std::string fault_at(const DocumentPosition& position, const std::string& reason);

/// Whether a fault here may cost geometry, and not only appearance.
bool holds_geometry(const DocumentPosition& position);

} // namespace lambent::scene
