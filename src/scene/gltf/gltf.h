// glTF 2.0 from .gltf and .glb files.
#pragma once

#include "base/error.h"
#include "scene/gltf_document/gltf_source.h"
#include "scene/scene.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lambent::scene {

/// Reads the default scene of a .gltf or .glb (told apart by content); without one the first, without any
/// all root nodes. Supports KHR_lights_punctual, KHR_texture_transform, KHR_materials_clearcoat,
/// KHR_materials_emissive_strength, KHR_materials_unlit, KHR_mesh_quantization, EXT_mesh_gpu_instancing and KHR_node_visibility.
///
/// The scene is as it stands: morph targets are applied at their default weights, skins as their joints are, and no
/// animation plays. Missing normals become flat, tangents are made where a normal texture needs them.
/// Meshes, materials and images that the scene does not show are left out. Transforms are worked out in double; where the
/// scene is far from the origin for its size, its places are relative to its middle (Scene::origin), at every moment to that
/// of the scene as it stands.
///
/// Buffers and images may be inside the file or beside it. A uri is percent-decoded and relative to the file's folder:
/// absolute paths and schemes other than data: are refused, and what leaves the reach, by ".." or by links.
///
/// A part that is broken is left out or mended, and told of in `warnings`, faults of one kind in one line; so is what is
/// ignored: docs/GLTF.md says what costs what. Throws Error(bad_input) naming the file, the element (like "accessor 3")
/// and the reason where the file is no glTF 2.0, where faults leave nothing to draw, and where it asks for too much: safe
/// for untrusted files, which may not ask for much more memory than they have bytes.
Scene load_gltf(const std::filesystem::path& path, Warnings& warnings, const Reach& reach = {});
/// The same of bytes in memory.
Scene load_gltf_bytes(const GltfSource& source, Warnings& warnings);

/// A moment of one of a file's animations.
struct Moment {
    int animation = 0;    ///< index into Scene::animations
    double seconds = 0.0; ///< clamped to the animation's duration
};

/// A file that can be looked at again and again, at every moment of its animations. What it throws is as load_gltf
/// says, and so is what it reads. Its const functions may be called by several threads at once.
class GltfFile {
public:
    /// Reads the file, its buffers and its animations, whose curves are checked; images and shapes are looked at later.
    GltfFile(const std::filesystem::path& path, Warnings& warnings, const Reach& reach = {});
    /// The same of bytes in memory, which must outlive it.
    GltfFile(const GltfSource& source, Warnings& warnings);
    ~GltfFile();
    GltfFile(GltfFile&&) noexcept;
    GltfFile& operator=(GltfFile&&) noexcept;

    const std::vector<AnimationInfo>& animations() const;

    /// The files beside it that it names: buffers and images, also those that the scene does not show. None where it is
    /// read from memory.
    const std::vector<std::filesystem::path>& files() const;

    /// The scene at a moment, or as load_gltf reads it. Nodes, joints, morph targets, and with them cameras and lights,
    /// go where the animation has them; rest_bounds says where the scene is without. In a file with animations the last
    /// mesh is empty: instances show it while they are flattened.
    /// Throws Error(usage) for an animation that is not there, else Error(bad_input).
    Scene scene(const std::optional<Moment>& moment, Warnings& warnings) const;

    /// The same without images, for a renderer that has them, and without warnings. Instances, meshes, materials and
    /// indices are in number and order those of scene() at any moment; vertices, triangles, cameras and lights may not
    /// be. What no animation changes is read once, by the first call. Throws as scene(), too where something is too
    /// far away at this moment.
    Scene pose(const Moment& moment) const;

private:
    struct Opened;
    std::unique_ptr<const Opened> opened_;
};

} // namespace lambent::scene
