#include "scene/gltf/gltf_layout.h"

#include "scene/gltf_document/gltf_losses.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace lambent::scene {
namespace {

// Limit of the elements of accessors without a bufferView, which are zeros.
constexpr std::size_t most_zeros = 1'000'000;

// Components of an element. The type must be one that glTF defines.
std::size_t components_of(std::string_view type)
{
    if (type == "SCALAR")
        return 1;
    const auto side = static_cast<std::size_t>(type.back() - '0');
    return type.starts_with("MAT") ? side * side : side;
}

// Bytes of one component; 0 for unknown types, since those of sparse indices were not checked before.
std::size_t component_bytes(int component)
{
    switch (component) {
    case gltf::Component::i8:
    case gltf::Component::u8:
        return 1;
    case gltf::Component::i16:
    case gltf::Component::u16:
        return 2;
    case gltf::Component::u32:
    case gltf::Component::f32:
        return 4;
    default:
        return 0;
    }
}

} // namespace

std::size_t AccessorLayout::element_bytes() const
{
    return component_bytes(component) * components;
}

const gltf::Accessor& find_accessor(const Document& document, const AccessorUse& use)
{
    const auto& accessors = document.model.accessors;
    if (use.accessor < 0 || static_cast<std::size_t>(use.accessor) >= accessors.size())
        document.fail(use.what, ": accessor ", use.accessor, " does not exist");
    const gltf::Accessor& accessor = accessors[static_cast<std::size_t>(use.accessor)];
    if (accessor.is_broken)
        throw told_already();
    return accessor;
}

std::string accessor_name(int accessor)
{
    return text("accessor ", accessor);
}

const std::uint8_t* check_run(const Document& document, const ElementRun& run, const std::string& name)
{
    const auto view = view_bytes(document, run.buffer_view, name);
    const std::uint64_t left = run.offset > view.size() ? 0 : view.size() - run.offset;
    // (count - 1) * stride + element <= left, written so that nothing can overflow.
    if (run.count != 0 && (run.element > left || (run.count - 1) > (left - run.element) / run.stride))
        document.fail(name, ": ", run.count, " elements of ", run.element, " bytes do not fit in bufferView ",
                      run.buffer_view, " (", view.size(), " bytes)");
    return view.data() + std::min<std::uint64_t>(run.offset, view.size());
}

AccessorLayout check_layout(const Document& document, const AccessorUse& use)
{
    const gltf::Accessor& accessor = find_accessor(document, use);
    const std::string name = accessor_name(use.accessor);
    AccessorLayout layout;
    layout.count = accessor.count;
    layout.component = accessor.component_type;
    layout.components = components_of(accessor.type);
    layout.normalized = accessor.normalized || use.normalized;
    layout.stride = layout.element_bytes();
    if (layout.count > std::numeric_limits<std::uint32_t>::max())
        document.fail(name, ": ", layout.count, " elements exceed 32-bit indices");
    if (accessor.buffer_view < 0) {
        if (layout.count > most_zeros)
            document.fail(name, ": ", layout.count, " elements without a bufferView, at most ", most_zeros,
                          " are read");
        return layout;
    }
    const std::uint64_t element = layout.stride;
    view_bytes(document, accessor.buffer_view, name); // throws if there is no such view
    const auto& view = document.model.buffer_views[static_cast<std::size_t>(accessor.buffer_view)];
    if (view.byte_stride != 0 && view.byte_stride < element)
        document.fail(name, ": elements of ", element, " bytes overlap in bufferView ", accessor.buffer_view,
                      " (byteStride ", view.byte_stride, ")");
    if (view.byte_stride != 0)
        layout.stride = view.byte_stride;
    layout.first = check_run(
        document, {accessor.buffer_view, accessor.byte_offset, layout.count, layout.stride, element}, name);
    return layout;
}

} // namespace lambent::scene
