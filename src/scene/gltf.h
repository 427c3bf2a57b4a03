// glTF 2.0 from .gltf and .glb files.
#pragma once

#include "base/error.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace lambent::scene {

/// Reads the default scene of a .gltf or .glb (told apart by content); without one the first, without any
/// all root nodes. Supports KHR_lights_punctual, KHR_texture_transform, KHR_materials_emissive_strength,
/// KHR_materials_unlit and KHR_mesh_quantization.
///
/// The picture is still: morph targets are applied at their default weights, skins in the rest pose,
/// animations ignored. Missing normals become flat, tangents are made where a normal texture needs them.
/// Meshes, materials and images that the scene does not show are left out.
///
/// Buffers and images may be inside the file or beside it. A uri is percent-decoded and must lead to the
/// folder of the glTF or below: absolute paths, schemes other than data:, and paths that leave by ".." are
/// refused.
///
/// What is ignored or mended without harm is added to `warnings`. Throws Error(bad_input) naming the file,
/// the element (like "accessor 3") and the reason; safe for untrusted files, which may not ask for much
/// more memory than they have bytes.
Scene load_gltf(const std::filesystem::path& path, Warnings& warnings);

} // namespace lambent::scene
