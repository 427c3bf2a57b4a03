#include "vulkan/compute.h"

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
    return resource.texture && resource.sampler != VK_NULL_HANDLE &&
           resource.texture->shape().cube == (binding == Binding::sampled_cube);
}

} // namespace

ComputePipeline::ComputePipeline(const Device& device, const PipelineCache& cache,
                                 const ComputeShader& shader)
    : device_(device), bindings_(shader.bindings), push_bytes_(shader.push_bytes)
{
    try {
        make_layouts();
        make_pipeline(cache, shader);
    } catch (...) {
        release();
        throw;
    }
}

void ComputePipeline::make_layouts()
{
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const Binding binding : bindings_)
        bindings.push_back({static_cast<std::uint32_t>(bindings.size()), type_of(binding), 1,
                            VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    auto set = typed<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    set.bindingCount = static_cast<std::uint32_t>(bindings.size());
    set.pBindings = bindings.data();
    check(device_.call().vkCreateDescriptorSetLayout(device_.handle(), &set, nullptr, &set_layout_),
          "describing a shader's bindings");
    const VkPushConstantRange push = {VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes_};
    auto layout = typed<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    layout.setLayoutCount = 1;
    layout.pSetLayouts = &set_layout_;
    layout.pushConstantRangeCount = push_bytes_ > 0 ? 1 : 0;
    layout.pPushConstantRanges = &push;
    check(device_.call().vkCreatePipelineLayout(device_.handle(), &layout, nullptr, &layout_),
          "describing a shader");
}

void ComputePipeline::make_pipeline(const PipelineCache& cache, const ComputeShader& shader)
{
    auto code = typed<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    code.codeSize = shader.spirv.size_bytes();
    code.pCode = shader.spirv.data();
    VkShaderModule module = VK_NULL_HANDLE;
    check(device_.call().vkCreateShaderModule(device_.handle(), &code, nullptr, &module), "reading a shader");

    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t i = 0; i < shader.constants.size(); ++i)
        entries.push_back({i, static_cast<std::uint32_t>(i * sizeof(std::uint32_t)), sizeof(std::uint32_t)});
    const VkSpecializationInfo constants = {static_cast<std::uint32_t>(entries.size()), entries.data(),
                                            shader.constants.size() * sizeof(std::uint32_t),
                                            shader.constants.data()};
    auto info = typed<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage = typed<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = &constants;
    info.layout = layout_;
    const VkResult result = device_.call().vkCreateComputePipelines(device_.handle(), cache.handle(), 1,
                                                                    &info, nullptr, &pipeline_);
    device_.call().vkDestroyShaderModule(device_.handle(), module, nullptr);
    check(result, "compiling a shader");
}

void ComputePipeline::release()
{
    device_.call().vkDestroyPipeline(device_.handle(), pipeline_, nullptr);
    device_.call().vkDestroyPipelineLayout(device_.handle(), layout_, nullptr);
    device_.call().vkDestroyDescriptorSetLayout(device_.handle(), set_layout_, nullptr);
}

ComputePipeline::~ComputePipeline()
{
    release();
}

BindingSet::BindingSet(const Device& device, const ComputePipeline& pipeline,
                       std::span<const Resource> resources)
    : device_(device)
{
    if (resources.size() != pipeline.bindings().size())
        throw std::invalid_argument("a shader is given another number of resources than it has bindings");
    std::vector<VkDescriptorPoolSize> sizes;
    for (std::size_t i = 0; i < resources.size(); ++i) {
        if (!fits(pipeline.bindings()[i], resources[i]))
            throw std::invalid_argument("a shader is given a resource of another kind than its binding");
        sizes.push_back({type_of(pipeline.bindings()[i]), 1});
    }
    auto pool = typed<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    pool.maxSets = 1;
    pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    pool.pPoolSizes = sizes.data();
    check(device.call().vkCreateDescriptorPool(device.handle(), &pool, nullptr, &pool_),
          "making room for bindings");
    auto info = typed<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    info.descriptorPool = pool_;
    info.descriptorSetCount = 1;
    const VkDescriptorSetLayout layout = pipeline.set_layout();
    info.pSetLayouts = &layout;
    const VkResult result = device.call().vkAllocateDescriptorSets(device.handle(), &info, &set_);
    if (result != VK_SUCCESS)
        device.call().vkDestroyDescriptorPool(device.handle(), pool_, nullptr);
    check(result, "making bindings");
    fill(pipeline, resources);
}

void BindingSet::fill(const ComputePipeline& pipeline, std::span<const Resource> resources) const
{
    for (std::uint32_t i = 0; i < resources.size(); ++i) {
        const Resource& resource = resources[i];
        auto write = typed<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
        write.dstSet = set_;
        write.dstBinding = i;
        write.descriptorCount = 1;
        write.descriptorType = type_of(pipeline.bindings()[i]);
        VkDescriptorBufferInfo buffer{};
        VkDescriptorImageInfo image{};
        if (resource.buffer) {
            buffer = {resource.buffer->handle(), 0, VK_WHOLE_SIZE};
            write.pBufferInfo = &buffer;
        } else {
            image = {resource.sampler, resource.texture->view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
            write.pImageInfo = &image;
        }
        device_.call().vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
    }
}

BindingSet::~BindingSet()
{
    device_.call().vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
}

Sampler::Sampler(const Device& device, bool around) : device_(device)
{
    auto info = typed<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    info.addressModeU = around ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.maxLod = VK_LOD_CLAMP_NONE;
    check(device.call().vkCreateSampler(device.handle(), &info, nullptr, &sampler_), "making a sampler");
}

Sampler::~Sampler()
{
    device_.call().vkDestroySampler(device_.handle(), sampler_, nullptr);
}

} // namespace lambent::vulkan
