// glTF 2.0 from .gltf and .glb files.
#pragma once

#include "base/error.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace lambent::scene {

/// Reads the default scene of a .gltf or .glb (told apart by content). Supports KHR_lights_punctual,
/// KHR_texture_transform, KHR_materials_emissive_strength, KHR_materials_unlit and KHR_mesh_quantization.
/// Missing normals and tangents are generated. What is ignored without harm is added to `warnings`.
/// Throws Error(bad_input) naming the file, the element (like "accessor 3") and the reason; safe for
/// untrusted files.
Scene load_gltf(const std::filesystem::path& path, Warnings& warnings);

} // namespace lambent::scene
