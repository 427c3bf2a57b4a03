// A scene in the memory of a device.
#pragma once

#include "draw/textures/scene_textures.h"
#include "gpu_layout/layout.h"
#include "vulkan/commands.h"

#include <map>
#include <optional>
#include <vector>

namespace lambent::draw {

/// Triangles, materials, textures and draw commands of a scene. Throws Error(no_device).
class SceneOnDevice {
public:
    /// `posed` is `scene` or the same scene at another time; its images are not read. The device must outlive this; the
    /// scenes need not. `transfer` is that of colour textures.
    SceneOnDevice(const vulkan::Device& device, const scene::Scene& scene, const scene::Scene& posed,
                  TexelTransfer transfer);

    /// Changes to another time; materials and textures are kept. No drawing may be in progress. Throws
    /// Error(no_device); then another pose() has to succeed before drawing.
    void pose(const vulkan::Device& device, const scene::Scene& posed);

    const vulkan::Buffer& geometry() const { return *geometry_; } ///< words, read by address
    const vulkan::Buffer& positions() const { return *positions_; }
    const vulkan::Buffer& indices() const { return *indices_; }
    const vulkan::Buffer& instances() const { return *instances_; }
    const vulkan::Buffer& meshes() const { return *meshes_; }
    const vulkan::Buffer& materials() const { return *materials_; }
    const vulkan::Buffer& textures() const { return *textures_; }
    const vulkan::Buffer& codes() const { return *codes_; }

    /// The draw commands, grouped by culling mode.
    const std::vector<vulkan::DrawBatch>& batches() const { return batches_; }

    /// Whether any material is unlit.
    bool has_unlit() const { return has_unlit_; }

    /// Whether any material has lobes over its base.
    bool has_layers() const { return has_layers_; }

    /// Whether any material lets surfaces behind it be seen.
    bool transparent() const { return transparent_; }

private:
    /// For each mesh: the offset in geometry(), in words, of each set of texture coordinates.
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
