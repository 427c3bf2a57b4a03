#include "scene/vertices.h"

namespace lambent::scene {
namespace {

template <class Element>
void gather(std::vector<Element>& elements, std::span<const std::uint32_t> source)
{
    if (elements.empty())
        return;
    std::vector<Element> gathered;
    gathered.reserve(source.size());
    for (const std::uint32_t index : source)
        gathered.push_back(elements[index]);
    elements = std::move(gathered);
}

template <class Element>
void append(std::vector<Element>& elements, std::span<const std::uint32_t> source)
{
    if (elements.empty())
        return;
    elements.reserve(elements.size() + source.size());
    for (const std::uint32_t index : source)
        elements.push_back(elements[index]);
}

template <class Action>
void for_each_array(Mesh& mesh, Action action)
{
    action(mesh.positions);
    action(mesh.normals);
    action(mesh.tangents);
    for (auto& [number, set] : mesh.texcoords)
        action(set);
    action(mesh.colors);
}

} // namespace

void gather_vertices(Mesh& mesh, std::span<const std::uint32_t> source)
{
    for_each_array(mesh, [&](auto& elements) { gather(elements, source); });
}

void split_all_vertices(Mesh& mesh)
{
    std::vector<std::uint32_t> source;
    source.reserve(mesh.triangles.size() * 3);
    for (glm::uvec3& triangle : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(source.size());
        source.insert(source.end(), {triangle.x, triangle.y, triangle.z});
        triangle = {first, first + 1, first + 2};
    }
    gather_vertices(mesh, source);
}

void append_copies(Mesh& mesh, std::span<const std::uint32_t> source)
{
    for_each_array(mesh, [&](auto& elements) { append(elements, source); });
}

} // namespace lambent::scene
