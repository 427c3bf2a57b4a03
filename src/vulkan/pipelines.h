// Shaders, compiled for a device: compute, and triangles.
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

/// Owned by whoever holds it. The device must outlive it.
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

/// Triangles into one picture with depth. Viewport, culling and winding are left to the commands.
struct RasterShader {
    Spirv vertex, fragment;
    Constants constants; ///< of the fragment shader
    VkFormat color = VK_FORMAT_UNDEFINED, depth = VK_FORMAT_UNDEFINED;
    std::uint32_t vertex_stride = 0; ///< bytes; attribute 0 is a vec3 at the beginning
};

/// What is in front has the greater depth.
class RasterPipeline : public Pipeline {
public:
    /// Throws Error(no_device).
    RasterPipeline(const PipelineCache& cache, const ShaderLayout& layout, const RasterShader& shader);
};

} // namespace lambent::vulkan
