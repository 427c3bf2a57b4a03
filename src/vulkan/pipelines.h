// Compute and raster pipelines: shaders compiled for a device.
#pragma once

#include "vulkan/bindings.h"
#include "vulkan/pipeline_cache.h"

#include <span>
#include <vector>

namespace lambent::vulkan {

/// SPIR-V with the entry point "main".
using Spirv = std::span<const std::uint32_t>;

/// Specialization constant i is constants[i].
using Constants = std::span<const std::uint32_t>;

/// Owns a Vulkan pipeline. The device must outlive it.
class Pipeline {
public:
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;

    VkPipeline handle() const { return pipeline_; }

protected:
    explicit Pipeline(const Device& device) : device_(device) {}
    ~Pipeline();

    const Device& device_;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

class ComputePipeline : public Pipeline {
public:
    /// Throws Error(no_device).
    ComputePipeline(const PipelineCache& cache, const ShaderLayout& layout, Spirv code,
                    Constants constants = {});
};

/// Draws triangles into one color attachment, with depth. Viewport, culling and front face are dynamic state.
struct RasterShader {
    Spirv vertex, fragment;
    Constants constants; ///< of the fragment shader
    VkFormat color = VK_FORMAT_UNDEFINED, depth = VK_FORMAT_UNDEFINED;
    std::uint32_t vertex_stride = 0; ///< bytes; attribute 0 is a vec3 at the start of a vertex
};

/// Depth is reversed: nearer surfaces have greater depth.
class RasterPipeline : public Pipeline {
public:
    /// Throws Error(no_device).
    RasterPipeline(const PipelineCache& cache, const ShaderLayout& layout, const RasterShader& shader);
};

} // namespace lambent::vulkan
