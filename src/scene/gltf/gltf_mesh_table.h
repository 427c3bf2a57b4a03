// Which of the primitives that were read become meshes of the scene.
#pragma once

#include "scene/gltf/gltf_mesh.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lambent::scene {

/// Turns what was read into meshes, in the order of first use.
class MeshTable {
public:
    /// `materials` of each result, as the file numbers them. In a file that `moves`, what was lost at this moment may be
    /// there at another, and becomes an empty mesh. All must outlive it; results that become meshes lose theirs.
    MeshTable(std::span<PrimitiveResult> results, std::span<const int> materials, bool moves,
              DrawnMeshes& drawn);

    /// The mesh of a result, for one instance more; -1: there is none, for nothing is in it, or it holds points and lines
    /// that have been shown too often, which is counted.
    int use(std::size_t result);

    const PrimitiveResult& result(std::size_t index) const { return results_[index]; }
    DrawnMeshes& drawn() { return drawn_; }
    std::size_t left_out() const { return left_out_; }

private:
    int add(std::size_t result);

    std::span<PrimitiveResult> results_;
    std::span<const int> materials_;
    bool moves_;
    DrawnMeshes& drawn_;
    std::vector<int> mesh_of_; ///< each result; -1: none yet
    std::size_t repeated_ = 0, left_out_ = 0;
};

/// Points and lines become triangles for each instance that shows them: the first is free, of others so many are drawn.
constexpr std::size_t most_repeated_lines = 4'000'000;

} // namespace lambent::scene
