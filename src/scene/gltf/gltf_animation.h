// The animations of a glTF, and where they have its nodes at a moment.
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
    int node = 0; ///< of the file
    Animated property = Animated::translation;
    Curve curve;
};

struct Animation {
    AnimationInfo info;
    std::vector<Track> tracks;
};

/// Reads every animation of the file. Channels that move nothing that is known are left out with a warning, and so are
/// those with a fault: indices that do not exist, times that descend, counts that do not fit, values that are not finite,
/// and more keys than a file of its size may have. Keys at one time are a jump, with a warning.
std::vector<Animation> read_animations(const Document& document, Warnings& warnings);

/// Where the nodes are at a moment; none: as the file has them. Holds all nodes that any of the animations moves,
/// whatever the moment. Seconds are clamped to the animation's. Throws Error(usage) for an animation that is not there.
Pose pose_of(const Document& document, std::span<const Animation> animations,
             const std::optional<Moment>& moment);

} // namespace lambent::scene
