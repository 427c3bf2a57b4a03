// Vertices that are not what they may be, made so.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lambent::scene {

/// The largest number of a component type: as an index it is no vertex, but ends one strip, fan or triangle and begins
/// another. [glTF 2.0, 3.7.2.1; OpenGL 4.6, 10.3.6]
std::uint32_t restart_index(int component_type);

/// The runs of corners between restarts; empty ones are left out.
std::vector<std::span<const std::uint32_t>> runs_between(std::span<const std::uint32_t> corners,
                                                         std::uint32_t restart);

/// Vertex colours brought into [0, 1]. [glTF 2.0, 3.7.2.1] Returns how many were clearly outside.
std::size_t clamp_colors(std::vector<glm::vec4>& colors);

/// Removes the triangles of vertices whose positions are not finite, and puts those vertices where another is. Returns how
/// many triangles went.
std::size_t remove_broken_triangles(Mesh& mesh);

} // namespace lambent::scene
