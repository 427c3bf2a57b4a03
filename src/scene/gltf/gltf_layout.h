// Where the elements of accessors are in memory, with all checks.
#pragma once

#include "scene/gltf/gltf_accessor.h"
#include "scene/gltf_document/gltf_document.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace lambent::scene {

/// The layout of elements in memory.
struct AccessorLayout {
    const std::uint8_t* first = nullptr; ///< null: all zeros
    std::size_t stride = 0;              ///< bytes from one element to the next
    std::size_t count = 0;
    int component = 0; ///< gltf::Component
    std::size_t components = 0;
    bool normalized = false;

    /// Bytes of one element; 0 if `component` is none of glTF's.
    std::size_t element_bytes() const;
};

/// `count` elements of `element` bytes, `stride` bytes apart, from `offset` in a bufferView.
struct ElementRun {
    int buffer_view;
    std::uint64_t offset;
    std::uint64_t count;
    std::uint64_t stride;
    std::uint64_t element;
};

/// The accessor of a request. Throws Error(bad_input) if it does not exist or is broken.
const gltf::Accessor& find_accessor(const Document& document, const AccessorUse& use);

/// The name of an accessor in messages: "accessor 3".
std::string accessor_name(int accessor);

/// The address of the first element. Throws Error(bad_input), in which `name` names the run's user, if the view does
/// not hold all of them.
const std::uint8_t* check_run(const Document& document, const ElementRun& run, const std::string& name);

/// The layout of an accessor, without its sparse part. Throws Error(bad_input) if its elements are not all inside its
/// bufferView, or if it has none and more than a million elements.
AccessorLayout check_layout(const Document& document, const AccessorUse& use);

} // namespace lambent::scene
