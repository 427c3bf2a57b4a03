// A scene where a device can draw it.
#pragma once

#include "draw/textures/scene_textures.h"
#include "gpu_layout/layout.h"
#include "vulkan/commands.h"

#include <map>
#include <optional>
#include <vector>

namespace lambent::draw {

/// Triangles, materials and textures, and the draws that show them all. Throws Error(no_device).
class SceneOnDevice {
public:
    /// `posed` is the scene or it at another moment, whose images are not looked at. The device must outlive it; the
    /// scenes need not. `transfer`: of colours.
    SceneOnDevice(const vulkan::Device& device, const scene::Scene& scene, const scene::Scene& posed,
                  TexelTransfer transfer);

    /// Goes on to another moment; materials and textures stay. Nothing may be drawing. Throws Error(no_device), and
    /// must then be posed again before it is drawn.
    void pose(const vulkan::Device& device, const scene::Scene& posed);

    const vulkan::Buffer& geometry() const { return *geometry_; } ///< words, read by address
    const vulkan::Buffer& positions() const { return *positions_; }
    const vulkan::Buffer& indices() const { return *indices_; }
    const vulkan::Buffer& instances() const { return *instances_; }
    const vulkan::Buffer& meshes() const { return *meshes_; }
    const vulkan::Buffer& materials() const { return *materials_; }
    const vulkan::Buffer& textures() const { return *textures_; }
    const vulkan::Buffer& codes() const { return *codes_; }

    /// What is drawn with backs and what without.
    const std::vector<vulkan::DrawBatch>& batches() const { return batches_; }

    /// Whether anything is shown without lighting.
    bool has_unlit() const { return has_unlit_; }

    /// Whether it has materials with lobes over their base.
    bool has_layers() const { return has_layers_; }

    /// Whether something is behind other things and seen.
    bool transparent() const { return transparent_; }

private:
    /// Of each mesh, where each of its sets of texture coordinates begins in the geometry.
    using SetPlaces = std::vector<std::map<int, gpu_layout::uint>>;

    SetPlaces place_geometry(const vulkan::Device& device, const scene::Scene& scene);
    void place_instances(const vulkan::Device& device, const scene::Scene& scene, const SetPlaces& sets);
    void place_materials(const vulkan::Device& device, const scene::Scene& scene,
                         const SceneTextures& textures);
    void place_textures(const vulkan::Device& device, const SceneTextures& textures);
    void plan_draws(const vulkan::Device& device, const scene::Scene& scene);

    std::optional<vulkan::Buffer> geometry_, positions_, indices_, instances_, meshes_, materials_, textures_,
        codes_, draws_;
    std::vector<vulkan::Buffer> texels_;
    std::vector<vulkan::DrawBatch> batches_;
    bool has_unlit_ = false;
    bool has_layers_ = false;
    bool transparent_ = false;
};

} // namespace lambent::draw
