// Where in a document a fault is.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lambent::scene {

/// A chain of these on the stack, turned into words only for a message. Tables, not files, say how long it may grow.
struct Place {
    const Place* outer = nullptr;
    std::string_view name;
    std::ptrdiff_t index = -1;
};

/// "mesh 0, primitive 1: REASON".
std::string fault_at(const Place& place, const std::string& reason);

/// Whether what is lost here may be something to draw, and not only how it looks.
bool holds_geometry(const Place& place);

} // namespace lambent::scene
