// Cameras and lights of the drawn nodes.
#pragma once

#include "scene/gltf_document/gltf_document.h"
#include "scene/scene.h"
#include "scene/gltf/gltf_nodes.h"

#include <vector>

namespace lambent::scene {

/// Cameras with the scale, and what it mirrors, taken out of their transform. One whose axes have collapsed, that does not
/// exist or has an impossible angle or size is left out with a warning; aspects, planes and signs that make no sense are
/// passed over with one.
std::vector<Camera> read_cameras(const Document& document, const NodeTree& nodes, Warnings& warnings);

/// KHR_lights_punctual: lights shine along their node's -Z. As above; cone angles are clamped, and a negative range counts
/// as none, with a warning.
std::vector<Light> read_lights(const Document& document, const NodeTree& nodes, Warnings& warnings);

} // namespace lambent::scene
