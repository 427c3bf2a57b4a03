// Repair of invalid vertices.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <vector>

namespace lambent::scene {

/// Clamps vertex colours to [0, 1]. [glTF 2.0, 3.7.2.1] Returns how many were outside by more than rounding errors.
std::size_t clamp_colors(std::vector<glm::vec4>& colors);

/// Removes triangles, lines and points with vertices whose positions are not finite, and moves these vertices to the
/// position of another. Returns how many elements were removed.
std::size_t remove_broken_elements(Mesh& mesh);

} // namespace lambent::scene
