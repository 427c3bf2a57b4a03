// The animations of a glTF, and the poses of its nodes at a moment.
#pragma once

#include "scene/gltf/gltf.h"
#include "scene/gltf/gltf_curve.h"
#include "scene/gltf_document/gltf_document.h"
#include "scene/gltf/gltf_nodes.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lambent::scene {

enum class Animated : std::uint8_t { translation, rotation, scale, weights };

/// One property of a node over time.
struct Track {
    int node = 0; ///< index in the file
    Animated property = Animated::translation;
    Curve curve;
};

struct Animation {
    AnimationInfo info;
    std::vector<Track> tracks;
};

/// Reads all animations of the file. Channels with unknown targets are left out with a warning, and so are faulty
/// ones: indices that do not exist, descending times, counts that do not match, values that are not finite, and more
/// keys than a file of its size may have. Two keys at the same time are a jump, with a warning.
std::vector<Animation> read_animations(const Document& document, Warnings& warnings);

/// The poses of nodes at a moment; without one, at rest. Always holds all nodes that any of the animations moves.
/// Seconds are clamped to the animation's duration. Throws Error(usage) for an animation that does not exist.
Pose pose_of(const Document& document, std::span<const Animation> animations,
             const std::optional<Moment>& moment);

} // namespace lambent::scene
