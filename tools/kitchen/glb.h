// Scenes as glTF files, as far as the models of this folder need it.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace lambent {

/// A .glb of the scene's triangles: meshes with positions, normals, colours and texture coordinates, their instances,
/// materials with factors and a texture of the base colour. Emission above 1 is KHR_materials_emissive_strength.
/// If meshes of a material have vertex colours above 1, all of its meshes must have
/// vertex colours. [glTF 2.0]
std::vector<std::uint8_t> encode_glb(const scene::Scene& scene);

} // namespace lambent
