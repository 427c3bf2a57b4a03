// Materials, textures and samplers of the primitives that are drawn.
#pragma once

#include "scene/gltf_document/gltf_document.h"
#include "scene/gltf/gltf_primitive.h"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace lambent::scene {

struct MaterialTable {
    std::vector<Material> materials; ///< in the order of first use; never empty
    std::vector<int> scene_index;    ///< of each material of the file, and last of the default; -1: not used
    std::vector<int> images;         ///< the file's image for each index of an image in `materials`

    /// Index into `materials` for a primitive's material (-1, or one that does not exist: the default one).
    int index_of(int material) const;

    /// The same for points and lines, whose material must be double-sided and, without normals, `unlit`: the material
    /// itself, or a copy that is added.
    int line_index_of(int material, bool unlit);

private:
    std::map<std::pair<int, bool>, int> line_copies_; ///< by index, and whether it is unlit
};

/// Reads the listed materials (-1 is the default). Factors outside their range are clamped, and references that do not
/// exist and unknown settings are replaced by defaults, with a warning.
MaterialTable read_materials(const Document& document, std::span<const int> used, Warnings& warnings);

/// The vertex data that a material's textures need.
TextureNeeds texture_needs(const Material& material);

} // namespace lambent::scene
