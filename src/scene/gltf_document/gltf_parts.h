// Lists of a checked document that tinygltf does not get: it would refuse what is read here, or spend too much on it.
#pragma once

#include "scene/gltf_document/gltf_document.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace lambent::scene {

/// Each takes its list out of the document. Elements that could not be read are marked so, or left out where nothing
/// refers to them by number.
nlohmann::json take(nlohmann::json& document, const char* name);
std::vector<ImageSource> take_images(nlohmann::json& document);
std::vector<AnimationSource> take_animations(nlohmann::json& document);
std::vector<tinygltf::Mesh> take_meshes(nlohmann::json& document);

/// byteStride of each bufferView, 0 where it has none. tinygltf takes no odd ones.
std::vector<std::size_t> take_strides(nlohmann::json& document);

} // namespace lambent::scene
