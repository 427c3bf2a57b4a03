// Cameras and lights of the drawn nodes.
#pragma once

#include "scene/gltf_document/gltf_document.h"
#include "scene/scene.h"
#include "scene/gltf/gltf_nodes.h"

#include <vector>

namespace lambent::scene {

/// Cameras, whose transforms lose scaling and mirroring. A camera that does not exist, whose axes have collapsed, or
/// with an invalid angle or size is left out with a warning; invalid aspects, planes and signs are ignored with one.
std::vector<Camera> read_cameras(const Document& document, const NodeTree& nodes, Warnings& warnings);

/// Lights of KHR_lights_punctual, which shine along their node's -Z. Invalid ones are left out with a warning; cone
/// angles are clamped, and negative ranges ignored, with a warning.
std::vector<Light> read_lights(const Document& document, const NodeTree& nodes, Warnings& warnings);

} // namespace lambent::scene
