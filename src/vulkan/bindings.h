// What shaders read and write, and what stands there.
#pragma once

#include "vulkan/memory.h"

#include <span>
#include <vector>

namespace lambent::vulkan {

/// What stands at a binding of set 0.
enum class Binding { storage_buffer, sampled_cube, sampled_picture, sampled_stack };

/// The bindings that any number of shaders share, and their push constants. The device must outlive it.
class ShaderLayout {
public:
    /// Binding i is bindings[i]; `push_bytes` at most 128. All stages see all.
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

/// A thing to stand at a binding: a whole buffer, or a texture with its sampler.
struct Resource {
    const Buffer* buffer = nullptr;
    const Texture* texture = nullptr;
    VkSampler sampler = VK_NULL_HANDLE;
};

/// The things that shaders of a layout are run with. They and the layout must outlive it.
class BindingSet {
public:
    /// As many as the layout has bindings, of their kinds. Throws std::invalid_argument where not.
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

/// How texels are read.
enum class Filter {
    clamped, ///< linear between texels and levels, cut off at the edges
    around,  ///< the same, but u repeats, as longitudes do
    nearest, ///< one texel
};

class Sampler {
public:
    Sampler(const Device& device, Filter filter);
    ~Sampler();
    Sampler(const Sampler&) = delete;
    Sampler& operator=(const Sampler&) = delete;

    VkSampler handle() const { return sampler_; }

private:
    const Device& device_;
    VkSampler sampler_ = VK_NULL_HANDLE;
};

} // namespace lambent::vulkan
