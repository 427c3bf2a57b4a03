#include "scene/gltf/gltf_accessor.h"

#include "scene/gltf/gltf_layout.h"
#include "scene/index.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace lambent::scene {
namespace {

template <class Source>
Source load(const std::uint8_t* bytes)
{
    // Elements of a file may be unaligned for the processor.
    Source value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

template <class Target, class Source>
Target convert(Source value, bool normalized)
{
    if constexpr (std::is_floating_point_v<Source> || !std::is_floating_point_v<Target>) {
        return static_cast<Target>(value);
    } else {
        if (!normalized)
            return static_cast<Target>(value);
        // -128 and -127 both stand for -1. [glTF 2.0, 3.6.2.2]
        constexpr auto most = static_cast<float>(std::numeric_limits<Source>::max());
        return std::max(static_cast<float>(value) / most, -1.0f);
    }
}

template <class Source, class Target>
void copy_elements(const AccessorLayout& layout, std::span<const std::uint32_t> selection, Target* out)
{
    const std::size_t count = selection.empty() ? layout.count : selection.size();
    const std::size_t bytes = layout.element_bytes();
    if constexpr (std::is_same_v<Source, Target>) {
        if (selection.empty() && layout.stride == bytes) {
            std::memcpy(out, layout.first, count * bytes);
            return;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* element = layout.first + layout.stride * (selection.empty() ? i : selection[i]);
        if constexpr (std::is_same_v<Source, Target>) {
            std::memcpy(out, element, bytes);
            out += layout.components;
        } else {
            for (std::size_t c = 0; c < layout.components; ++c)
                *out++ = convert<Target>(load<Source>(element + c * sizeof(Source)), layout.normalized);
        }
    }
}

template <class Target>
void copy_any(const AccessorLayout& layout, std::span<const std::uint32_t> selection, Target* out)
{
    if (layout.first == nullptr || layout.count == 0)
        return;
    switch (layout.component) {
    case gltf::Component::i8:
        return copy_elements<std::int8_t>(layout, selection, out);
    case gltf::Component::u8:
        return copy_elements<std::uint8_t>(layout, selection, out);
    case gltf::Component::i16:
        return copy_elements<std::int16_t>(layout, selection, out);
    case gltf::Component::u16:
        return copy_elements<std::uint16_t>(layout, selection, out);
    case gltf::Component::u32:
        return copy_elements<std::uint32_t>(layout, selection, out);
    default:
        return copy_elements<float>(layout, selection, out);
    }
}

// The indices of the elements that the sparse part replaces.
std::vector<std::uint32_t> sparse_indices(const Document& document, const gltf::Accessor& accessor,
                                          const std::string& name)
{
    const gltf::Sparse& sparse = *accessor.sparse;
    AccessorLayout layout;
    layout.count = at(sparse.count);
    layout.component = sparse.indices.component_type;
    layout.components = 1;
    layout.stride = layout.element_bytes();
    if (layout.component == gltf::Component::f32 || layout.stride == 0)
        document.fail(name, ": sparse indices have componentType ", layout.component,
                      ", which is not allowed");
    layout.first = check_run(document,
                             {sparse.indices.buffer_view, at(sparse.indices.byte_offset), layout.count,
                              layout.stride, layout.stride},
                             name + ", sparse indices");
    std::vector<std::uint32_t> indices(layout.count);
    copy_any(layout, {}, indices.data());
    for (const std::uint32_t index : indices)
        if (index >= accessor.count)
            document.fail(name, ": sparse index ", index, " is past its ", accessor.count, " elements");
    return indices;
}

template <class Target>
void apply_sparse(const Document& document, const AccessorUse& use, const AccessorLayout& base, Target* out)
{
    const gltf::Accessor& accessor = find_accessor(document, use);
    const std::string name = accessor_name(use.accessor);
    const gltf::Sparse& sparse = *accessor.sparse;
    if (at(sparse.count) > accessor.count)
        document.fail(name, ": more sparse elements (", sparse.count, ") than elements (", accessor.count,
                      ")");
    const std::vector<std::uint32_t> indices = sparse_indices(document, accessor, name);
    AccessorLayout layout = base;
    layout.count = indices.size();
    layout.stride = base.element_bytes();
    layout.first = check_run(document,
                             {sparse.values.buffer_view, at(sparse.values.byte_offset), layout.count,
                              layout.stride, layout.stride},
                             name + ", sparse values");
    std::vector<Target> values(indices.size() * base.components);
    copy_any(layout, {}, values.data());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        std::size_t element = indices[i];
        if (!use.selection.empty()) {
            const auto found = std::lower_bound(use.selection.begin(), use.selection.end(), indices[i]);
            if (found == use.selection.end() || *found != indices[i])
                continue;
            element = static_cast<std::size_t>(found - use.selection.begin());
        }
        std::copy_n(&values[i * base.components], base.components, out + element * base.components);
    }
}

// Reads elements that consist of `components` numbers of type Target.
template <class Target, class Element>
std::vector<Element> read_elements(const Document& document, const AccessorUse& use,
                                   const AccessorLayout& layout)
{
    static_assert(sizeof(Element) % sizeof(Target) == 0);
    std::vector<Element> elements(use.selection.empty() ? layout.count : use.selection.size(), Element(0));
    auto* out = reinterpret_cast<Target*>(elements.data());
    copy_any(layout, use.selection, out);
    if (find_accessor(document, use).sparse && !elements.empty())
        apply_sparse(document, use, layout, out);
    return elements;
}

AccessorLayout check_type(const Document& document, const AccessorUse& use, std::string_view type)
{
    const AccessorLayout layout = check_layout(document, use);
    if (find_accessor(document, use).type != type)
        document.fail(use.what, ": accessor ", use.accessor, " is not ", type);
    return layout;
}

void check_integers(const Document& document, const AccessorUse& use, std::span<const int> allowed)
{
    const int component = find_accessor(document, use).component_type;
    if (std::find(allowed.begin(), allowed.end(), component) == allowed.end())
        document.fail(use.what, ": accessor ", use.accessor, " has componentType ", component,
                      ", which is not allowed");
}

} // namespace

std::size_t accessor_count(const Document& document, const AccessorUse& use)
{
    return find_accessor(document, use).count;
}

void check_accessor(const Document& document, const AccessorUse& use)
{
    check_layout(document, use);
}

std::size_t sparse_count(const Document& document, int accessor)
{
    const auto& sparse = find_accessor(document, {accessor, "sparse", false, {}}).sparse;
    return sparse ? at(sparse->count) : 0;
}

std::vector<glm::vec2> read_vec2(const Document& document, const AccessorUse& use)
{
    return read_elements<float, glm::vec2>(document, use, check_type(document, use, "VEC2"));
}

std::vector<glm::vec3> read_vec3(const Document& document, const AccessorUse& use)
{
    return read_elements<float, glm::vec3>(document, use, check_type(document, use, "VEC3"));
}

std::vector<glm::vec4> read_vec4(const Document& document, const AccessorUse& use)
{
    return read_elements<float, glm::vec4>(document, use, check_type(document, use, "VEC4"));
}

std::vector<glm::vec4> read_color(const Document& document, const AccessorUse& use)
{
    if (find_accessor(document, use).type != "VEC3")
        return read_vec4(document, use);
    const std::vector<glm::vec3> rgb = read_vec3(document, use);
    std::vector<glm::vec4> colors(rgb.size());
    std::transform(rgb.begin(), rgb.end(), colors.begin(), [](glm::vec3 c) { return glm::vec4(c, 1.0f); });
    return colors;
}

std::vector<glm::mat4> read_mat4(const Document& document, const AccessorUse& use)
{
    const AccessorLayout layout = check_type(document, use, "MAT4");
    check_floats(document, use);
    return read_elements<float, glm::mat4>(document, use, layout);
}

std::vector<float> read_scalars(const Document& document, const AccessorUse& use)
{
    return read_elements<float, float>(document, use, check_type(document, use, "SCALAR"));
}

void check_floats(const Document& document, const AccessorUse& use)
{
    constexpr int allowed[] = {gltf::Component::f32};
    check_integers(document, use, allowed);
}

std::vector<std::uint32_t> read_indices(const Document& document, const AccessorUse& use)
{
    constexpr int allowed[] = {gltf::Component::u8, gltf::Component::u16, gltf::Component::u32};
    const AccessorLayout layout = check_type(document, use, "SCALAR");
    check_integers(document, use, allowed);
    return read_elements<std::uint32_t, std::uint32_t>(document, use, layout);
}

std::vector<glm::u16vec4> read_joints(const Document& document, const AccessorUse& use)
{
    constexpr int allowed[] = {gltf::Component::u8, gltf::Component::u16};
    const AccessorLayout layout = check_type(document, use, "VEC4");
    check_integers(document, use, allowed);
    return read_elements<std::uint16_t, glm::u16vec4>(document, use, layout);
}

} // namespace lambent::scene
