// The meshes of a scene, made of the primitives that were read.
#pragma once

#include "scene/gltf/gltf_mesh.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lambent::scene {

/// Turns results into meshes, in the order of first use.
class MeshTable {
public:
    /// `materials` are the file's indices, one per result. In a file that `moves`, a primitive that is lost at this
    /// moment may be valid at another, and becomes an empty mesh. All arguments must outlive this; results that become
    /// meshes lose theirs.
    MeshTable(std::span<PrimitiveResult> results, std::span<const int> materials, bool moves,
              DrawnMeshes& drawn);

    /// The mesh of a result, for one more instance; -1 if it is empty, or if its points and lines exceed the limit,
    /// which is counted.
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
    std::vector<int> mesh_of_; ///< of each result; -1: none yet
    std::size_t repeated_ = 0, left_out_ = 0;
};

/// Limit of points and lines drawn by instances after a mesh's first: they become triangles for each instance anew.
constexpr std::size_t most_repeated_lines = 4'000'000;

} // namespace lambent::scene
