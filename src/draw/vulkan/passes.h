// The shaders of the passes, compiled for a device.
#pragma once

#include "draw/settings.h"
#include "vulkan/pipelines.h"

#include <memory>

namespace lambent::draw {

/// The specialisation of the shaders.
struct PassChoice {
    int looks = 1; ///< per pixel; the last is through its centre
    Model model = Model::ggx;
    MipLevel mip_level = MipLevel::matched;
    bool is_pipeline = false; ///< whether the report's pipeline is used
    bool textured = true;     ///< whether any material has textures
    bool layered = true;      ///< whether any material has lobes over its base
    bool through = true;      ///< whether any surface is transparent

    bool operator==(const PassChoice&) const = default;
};

/// The bindings that all shaders share. The device must outlive it.
std::unique_ptr<vulkan::ShaderLayout> pass_layout(const vulkan::Device& device);

constexpr VkFormat id_format = VK_FORMAT_R32G32_UINT, depth_format = VK_FORMAT_D32_SFLOAT;

/// The pipelines of the passes, each compiled on first use. All members throw Error(no_device).
class Passes {
public:
    /// The cache and the layout must outlive it.
    Passes(const vulkan::PipelineCache& cache, const vulkan::ShaderLayout& layout, const PassChoice& choice);

    const PassChoice& choice() const { return choice_; }

    /// `wave`: 0 for the nearest surfaces, 1 for those behind transparent ones.
    const vulkan::RasterPipeline& triangles(int wave);
    const vulkan::ComputePipeline& seen();
    const vulkan::ComputePipeline& edges();
    const vulkan::ComputePipeline& gather(int wave);
    const vulkan::ComputePipeline& surfaces();
    const vulkan::ComputePipeline& light(int pass); ///< gpu_layout::pass_*
    const vulkan::ComputePipeline& resolve(int wave);
    const vulkan::ComputePipeline& background();

private:
    using Compute = std::unique_ptr<vulkan::ComputePipeline>;

    const vulkan::ComputePipeline& made(Compute& place, vulkan::Spirv code,
                                        vulkan::Constants constants) const;

    const vulkan::PipelineCache& cache_;
    const vulkan::ShaderLayout& layout_;
    PassChoice choice_;
    std::unique_ptr<vulkan::RasterPipeline> triangles_[2];
    Compute seen_, edges_, gather_[2], surfaces_, light_[3], resolve_[2], background_;
};

} // namespace lambent::draw
