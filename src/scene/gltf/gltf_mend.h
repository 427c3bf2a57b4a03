// Vertices that are not what they may be, made so.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <vector>

namespace lambent::scene {

/// Vertex colours brought into [0, 1]. [glTF 2.0, 3.7.2.1] Returns how many were clearly outside.
std::size_t clamp_colors(std::vector<glm::vec4>& colors);

/// Removes the triangles, lines and points of vertices whose positions are not finite, and puts those vertices where another
/// is. Returns how many went.
std::size_t remove_broken_elements(Mesh& mesh);

} // namespace lambent::scene
