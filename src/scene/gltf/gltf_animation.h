// The animations of a glTF.
#pragma once

#include "scene/gltf/gltf_curve.h"
#include "scene/gltf_document/gltf_document.h"
#include "scene/scene.h"

#include <cstdint>
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

} // namespace lambent::scene
