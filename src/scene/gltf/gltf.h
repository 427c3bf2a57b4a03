// Loading of glTF 2.0 from .gltf and .glb files.
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

/// Reads the default scene of a .gltf or .glb (told apart by content), else the first scene, else (in a file without
/// scenes) all root nodes. Supports KHR_lights_punctual, KHR_texture_transform, KHR_materials_clearcoat,
/// KHR_materials_emissive_strength, KHR_materials_unlit, KHR_mesh_quantization, EXT_mesh_gpu_instancing and
/// KHR_node_visibility.
///
/// The scene is at rest: morph targets have their default weights, skins follow the joints of the file, and no
/// animation is applied. Missing normals become flat, and tangents are computed if a normal texture needs them.
/// Meshes, materials and images that the scene does not use are left out. Transforms are computed in double; if the
/// scene is far from the origin for its size, its positions are relative to its centre (Scene::origin), at every
/// moment to that of the scene at rest.
///
/// Buffers and images may be inside the file or beside it. A uri is percent-decoded and relative to the file's folder.
/// Absolute paths, schemes other than data: and paths that leave the reach, by ".." or by links, are refused.
///
/// Broken parts are left out or repaired, with `warnings`, one line for all faults of one kind; docs/GLTF.md lists the
/// faults and what each costs. Ignored properties cause warnings, too. Throws Error(bad_input), which names the file,
/// the element (like "accessor 3") and the reason, if the file is not glTF 2.0, if faults leave nothing to draw, and
/// if it asks for too much. Safe for untrusted files: memory is limited by a multiple of their size.
Scene load_gltf(const std::filesystem::path& path, Warnings& warnings, const Reach& reach = {});
/// The same for bytes in memory.
Scene load_gltf_bytes(const GltfSource& source, Warnings& warnings);

/// A time in one of a file's animations.
struct Moment {
    int animation = 0;    ///< index into Scene::animations
    double seconds = 0.0; ///< clamped to the animation's duration
};

/// An open file, whose scene can be read at any moment of its animations. Reads and throws like load_gltf. Several
/// threads may call const functions at once.
class GltfFile {
public:
    /// Reads the file, its buffers and its animations, whose curves are checked; images and meshes are read later.
    GltfFile(const std::filesystem::path& path, Warnings& warnings, const Reach& reach = {});
    /// The same for bytes in memory, which must outlive this.
    GltfFile(const GltfSource& source, Warnings& warnings);
    ~GltfFile();
    GltfFile(GltfFile&&) noexcept;
    GltfFile& operator=(GltfFile&&) noexcept;

    const std::vector<AnimationInfo>& animations() const;

    /// The files beside it that it names: buffers and images, also those that the scene does not use. Empty if the
    /// source has no folder.
    const std::vector<std::filesystem::path>& files() const;

    /// The scene at a moment, or at rest as load_gltf reads it. The animation moves nodes, joints and morph targets,
    /// and with them cameras and lights; rest_bounds are the bounds at rest. In a file with animations the last mesh
    /// is empty: instances refer to it while their transform is singular or too far away. Throws Error(usage) for an
    /// animation that does not exist, else Error(bad_input).
    Scene scene(const std::optional<Moment>& moment, Warnings& warnings) const;

    /// The same without images, for a renderer that has them already, and without warnings. Instances, meshes,
    /// materials and indices have the number and order of those of scene() at any moment; vertices, triangles, cameras
    /// and lights may differ. Meshes that no animation changes are read once, by the first call. Throws like scene(),
    /// also if everything is too far away at this moment.
    Scene pose(const Moment& moment) const;

private:
    struct Opened;
    std::unique_ptr<const Opened> opened_;
};

} // namespace lambent::scene
