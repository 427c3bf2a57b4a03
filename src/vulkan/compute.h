// A compute shader with what it reads and writes.
#pragma once

#include "vulkan/memory.h"
#include "vulkan/pipeline_cache.h"

#include <span>
#include <vector>

namespace lambent::vulkan {

/// What stands at a binding of set 0.
enum class Binding { storage_buffer, sampled_cube, sampled_picture };

struct ComputeShader {
    std::span<const std::uint32_t> spirv; ///< with the entry point "main"
    std::vector<Binding> bindings;        ///< binding i is bindings[i]
    std::uint32_t push_bytes = 0;         ///< of push constants, at most 128
    std::vector<std::uint32_t> constants; ///< specialization constant i is constants[i]
};

/// Compiled. The device and the cache must outlive it.
class ComputePipeline {
public:
    ComputePipeline(const Device& device, const PipelineCache& cache, const ComputeShader& shader);
    ~ComputePipeline();
    ComputePipeline(const ComputePipeline&) = delete;
    ComputePipeline& operator=(const ComputePipeline&) = delete;

    VkPipeline handle() const { return pipeline_; }
    VkPipelineLayout layout() const { return layout_; }
    VkDescriptorSetLayout set_layout() const { return set_layout_; }
    std::span<const Binding> bindings() const { return bindings_; }
    std::uint32_t push_bytes() const { return push_bytes_; }

private:
    void make_layouts();
    void make_pipeline(const PipelineCache& cache, const ComputeShader& shader);
    void release();

    const Device& device_;
    std::vector<Binding> bindings_;
    std::uint32_t push_bytes_;
    VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

/// A thing to stand at a binding: a whole buffer, or a texture with its sampler.
struct Resource {
    const Buffer* buffer = nullptr;
    const Texture* texture = nullptr;
    VkSampler sampler = VK_NULL_HANDLE;
};

/// The things that a pipeline is run with. They and the pipeline must outlive it.
class BindingSet {
public:
    /// As many as the pipeline has bindings, of their kinds. Throws std::invalid_argument where not.
    BindingSet(const Device& device, const ComputePipeline& pipeline, std::span<const Resource> resources);
    ~BindingSet();
    BindingSet(const BindingSet&) = delete;
    BindingSet& operator=(const BindingSet&) = delete;

    VkDescriptorSet handle() const { return set_; }

private:
    void fill(const ComputePipeline& pipeline, std::span<const Resource> resources) const;

    const Device& device_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

/// Linear between texels and levels. Owned by whoever holds it.
class Sampler {
public:
    /// `around`: u repeats, as longitudes do; else both are cut off at the edge.
    Sampler(const Device& device, bool around);
    ~Sampler();
    Sampler(const Sampler&) = delete;
    Sampler& operator=(const Sampler&) = delete;

    VkSampler handle() const { return sampler_; }

private:
    const Device& device_;
    VkSampler sampler_ = VK_NULL_HANDLE;
};

} // namespace lambent::vulkan
