#include "vulkan/bindings.h"

#include <stdexcept>

namespace lambent::vulkan {
namespace {

VkDescriptorType type_of(Binding binding)
{
    return binding == Binding::storage_buffer ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                              : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
}

bool fits(Binding binding, const Resource& resource)
{
    if (binding == Binding::storage_buffer)
        return resource.buffer != nullptr;
    if (!resource.texture || resource.sampler == VK_NULL_HANDLE)
        return false;
    const TextureShape& shape = resource.texture->shape();
    return shape.cube == (binding == Binding::sampled_cube) &&
           (shape.array_layers > 0) == (binding == Binding::sampled_array);
}

// A texture that is also a render target stays in the general layout, which allows both.
VkImageLayout layout_of(const Texture& texture)
{
    const bool drawn = (texture.shape().usage & VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT) != 0;
    return drawn ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
}

} // namespace

ShaderLayout::ShaderLayout(const Device& device, std::vector<Binding> bindings, std::uint32_t push_bytes)
    : device_(device), bindings_(std::move(bindings)), push_bytes_(push_bytes)
{
    std::vector<VkDescriptorSetLayoutBinding> list;
    for (const Binding binding : bindings_)
        list.push_back({static_cast<std::uint32_t>(list.size()), type_of(binding), 1, stages, nullptr});
    auto set = typed<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    set.bindingCount = static_cast<std::uint32_t>(list.size());
    set.pBindings = list.data();
    check(device.call().vkCreateDescriptorSetLayout(device.handle(), &set, nullptr, &set_),
          "creating a descriptor set layout");
    const VkPushConstantRange push = {stages, 0, push_bytes_};
    auto layout = typed<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    layout.setLayoutCount = 1;
    layout.pSetLayouts = &set_;
    layout.pushConstantRangeCount = push_bytes_ > 0 ? 1 : 0;
    layout.pPushConstantRanges = &push;
    const VkResult result = device.call().vkCreatePipelineLayout(device.handle(), &layout, nullptr, &layout_);
    if (result != VK_SUCCESS)
        release();
    check(result, "creating a pipeline layout");
}

void ShaderLayout::release()
{
    device_.call().vkDestroyPipelineLayout(device_.handle(), layout_, nullptr);
    device_.call().vkDestroyDescriptorSetLayout(device_.handle(), set_, nullptr);
}

ShaderLayout::~ShaderLayout()
{
    release();
}

BindingSet::BindingSet(const Device& device, const ShaderLayout& layout, std::span<const Resource> resources)
    : device_(device), layout_(layout)
{
    if (resources.size() != layout.bindings().size())
        throw std::invalid_argument("the number of resources differs from that of the bindings");
    std::vector<VkDescriptorPoolSize> sizes;
    for (std::size_t i = 0; i < resources.size(); ++i) {
        if (!fits(layout.bindings()[i], resources[i]))
            throw std::invalid_argument("the kind of a resource differs from that of its binding");
        sizes.push_back({type_of(layout.bindings()[i]), 1});
    }
    auto pool = typed<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    pool.maxSets = 1;
    pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    pool.pPoolSizes = sizes.data();
    check(device.call().vkCreateDescriptorPool(device.handle(), &pool, nullptr, &pool_),
          "creating a descriptor pool");
    auto info = typed<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    info.descriptorPool = pool_;
    info.descriptorSetCount = 1;
    const VkDescriptorSetLayout set_layout = layout.set();
    info.pSetLayouts = &set_layout;
    const VkResult result = device.call().vkAllocateDescriptorSets(device.handle(), &info, &set_);
    if (result != VK_SUCCESS)
        device.call().vkDestroyDescriptorPool(device.handle(), pool_, nullptr);
    check(result, "allocating a descriptor set");
    fill(resources);
}

void BindingSet::fill(std::span<const Resource> resources) const
{
    for (std::uint32_t i = 0; i < resources.size(); ++i) {
        const Resource& resource = resources[i];
        auto write = typed<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
        write.dstSet = set_;
        write.dstBinding = i;
        write.descriptorCount = 1;
        write.descriptorType = type_of(layout_.bindings()[i]);
        VkDescriptorBufferInfo buffer{};
        VkDescriptorImageInfo image{};
        if (resource.buffer) {
            buffer = {resource.buffer->handle(), 0, VK_WHOLE_SIZE};
            write.pBufferInfo = &buffer;
        } else {
            image = {resource.sampler, resource.texture->view(), layout_of(*resource.texture)};
            write.pImageInfo = &image;
        }
        device_.call().vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
    }
}

BindingSet::~BindingSet()
{
    device_.call().vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
}

SamplerObject::SamplerObject(const Device& device, Filter filter) : device_(device)
{
    const bool linear = filter != Filter::nearest;
    auto info = typed<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = info.minFilter = linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    info.mipmapMode = linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU =
        filter == Filter::around ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.maxLod = VK_LOD_CLAMP_NONE;
    check(device.call().vkCreateSampler(device.handle(), &info, nullptr, &sampler_), "creating a sampler");
}

SamplerObject::~SamplerObject()
{
    device_.call().vkDestroySampler(device_.handle(), sampler_, nullptr);
}

} // namespace lambent::vulkan
