#include "scene/gltf/gltf_mesh_table.h"

#include <utility>

namespace lambent::scene {

MeshTable::MeshTable(std::span<PrimitiveResult> results, std::span<const int> materials, bool moves,
                     DrawnMeshes& drawn)
    : results_(results), materials_(materials), moves_(moves), drawn_(drawn), mesh_of_(results.size(), -1)
{
}

int MeshTable::use(std::size_t result)
{
    if (mesh_of_[result] < 0)
        return mesh_of_[result] = add(result);
    const Mesh& mesh = drawn_.meshes[static_cast<std::size_t>(mesh_of_[result])];
    const std::size_t lines = mesh.points.size() + mesh.lines.size();
    if (lines > most_repeated_lines - repeated_) {
        ++left_out_;
        return -1;
    }
    repeated_ += lines;
    return mesh_of_[result];
}

int MeshTable::add(std::size_t result)
{
    PrimitiveResult& source = results_[result];
    Mesh& mesh = source.mesh;
    if (is_empty(mesh) && !(moves_ && source.is_lost))
        return -1;
    const int material = materials_[result];
    mesh.material = source.of_lines ? drawn_.materials.line_index_of(material, source.unlit)
                                    : drawn_.materials.index_of(material);
    drawn_.meshes.push_back(std::move(mesh));
    return static_cast<int>(drawn_.meshes.size()) - 1;
}

} // namespace lambent::scene
