// Descriptors: the buffers and textures that shaders read and write.
#pragma once

#include "vulkan/memory.h"

#include <span>
#include <vector>

namespace lambent::vulkan {

/// Kind of the resource at a binding of set 0.
enum class Binding { storage_buffer, sampled_cube, sampled_image, sampled_array };

/// Bindings and push constants shared by any number of shaders. The device must outlive it.
class ShaderLayout {
public:
    /// Binding i is bindings[i]; `push_bytes` is at most 128. All are visible to all stages.
    ShaderLayout(const Device& device, std::vector<Binding> bindings, std::uint32_t push_bytes);
    ~ShaderLayout();
    ShaderLayout(const ShaderLayout&) = delete;
    ShaderLayout& operator=(const ShaderLayout&) = delete;

    VkPipelineLayout handle() const { return layout_; }
    VkDescriptorSetLayout set() const { return set_; }
    std::span<const Binding> bindings() const { return bindings_; }
    std::uint32_t push_bytes() const { return push_bytes_; }

    static constexpr VkShaderStageFlags stages =
        VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;

private:
    void release();

    const Device& device_;
    std::vector<Binding> bindings_;
    std::uint32_t push_bytes_;
    VkDescriptorSetLayout set_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
};

/// The resource for a binding: a whole buffer, or a texture with a sampler.
struct Resource {
    const Buffer* buffer = nullptr;
    const Texture* texture = nullptr;
    VkSampler sampler = VK_NULL_HANDLE;
};

/// A descriptor set for a layout. The layout and the resources must outlive it.
class BindingSet {
public:
    /// Throws std::invalid_argument unless there is one resource of the right kind for each of the layout's bindings.
    BindingSet(const Device& device, const ShaderLayout& layout, std::span<const Resource> resources);
    ~BindingSet();
    BindingSet(const BindingSet&) = delete;
    BindingSet& operator=(const BindingSet&) = delete;

    VkDescriptorSet handle() const { return set_; }
    const ShaderLayout& layout() const { return layout_; }

private:
    void fill(std::span<const Resource> resources) const;

    const Device& device_;
    const ShaderLayout& layout_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

/// Filtering and addressing of a texture.
enum class Filter {
    clamped, ///< linear between texels and levels, clamped to the edges
    around,  ///< the same, but u repeats, as longitudes do
    nearest, ///< the nearest texel of the nearest level, clamped to the edges
};

class SamplerObject {
public:
    SamplerObject(const Device& device, Filter filter);
    ~SamplerObject();
    SamplerObject(const SamplerObject&) = delete;
    SamplerObject& operator=(const SamplerObject&) = delete;

    VkSampler handle() const { return sampler_; }

private:
    const Device& device_;
    VkSampler sampler_ = VK_NULL_HANDLE;
};

} // namespace lambent::vulkan
