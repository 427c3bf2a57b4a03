// The poses of a glTF's nodes at a moment of an animation.
#pragma once

#include "scene/gltf/gltf.h"
#include "scene/gltf/gltf_animation.h"
#include "scene/gltf/gltf_nodes.h"
#include "scene/gltf_document/gltf_document.h"

#include <optional>
#include <span>

namespace lambent::scene {

/// The poses of nodes at a moment; without one, at rest. Always holds all nodes that any of the animations moves.
/// Seconds are clamped to the animation's duration. Throws Error(usage) for an animation that does not exist.
Pose pose_of(const Document& document, std::span<const Animation> animations,
             const std::optional<Moment>& moment);

} // namespace lambent::scene
