#include "vulkan/pipelines.h"

#include <array>

namespace lambent::vulkan {
namespace {

class Module {
public:
    Module(const Device& device, Spirv code) : device_(device)
    {
        auto info = typed<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
        info.codeSize = code.size_bytes();
        info.pCode = code.data();
        check(device.call().vkCreateShaderModule(device.handle(), &info, nullptr, &module_),
              "creating a shader module");
    }
    ~Module() { device_.call().vkDestroyShaderModule(device_.handle(), module_, nullptr); }
    Module(const Module&) = delete;
    Module& operator=(const Module&) = delete;

    VkShaderModule handle() const { return module_; }

private:
    const Device& device_;
    VkShaderModule module_ = VK_NULL_HANDLE;
};

// The specialization constants in Vulkan's structures, which point into this object.
struct Specialization {
    std::vector<VkSpecializationMapEntry> entries;
    VkSpecializationInfo info{};

    explicit Specialization(Constants constants)
    {
        for (std::uint32_t i = 0; i < constants.size(); ++i)
            entries.push_back(
                {i, static_cast<std::uint32_t>(i * sizeof(std::uint32_t)), sizeof(std::uint32_t)});
        info = {static_cast<std::uint32_t>(entries.size()), entries.data(), constants.size_bytes(),
                constants.data()};
    }
};

VkPipelineShaderStageCreateInfo stage_of(VkShaderStageFlagBits stage, const Module& module,
                                         const Specialization& constants)
{
    auto info = typed<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage = stage;
    info.module = module.handle();
    info.pName = "main";
    info.pSpecializationInfo = &constants.info;
    return info;
}

// The state that all raster pipelines share.
struct CommonState {
    VkPipelineInputAssemblyStateCreateInfo assembly = typed<VkPipelineInputAssemblyStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
    VkPipelineViewportStateCreateInfo viewport =
        typed<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
    VkPipelineRasterizationStateCreateInfo raster = typed<VkPipelineRasterizationStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
    VkPipelineMultisampleStateCreateInfo samples =
        typed<VkPipelineMultisampleStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
    VkPipelineDepthStencilStateCreateInfo depth = typed<VkPipelineDepthStencilStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
    VkPipelineColorBlendAttachmentState written{};
    VkPipelineColorBlendStateCreateInfo blend =
        typed<VkPipelineColorBlendStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
    std::array<VkDynamicState, 4> states = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                            VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE};
    VkPipelineDynamicStateCreateInfo dynamic =
        typed<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);

    CommonState()
    {
        assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        viewport.viewportCount = viewport.scissorCount = 1;
        raster.polygonMode = VK_POLYGON_MODE_FILL;
        raster.lineWidth = 1.0f;
        samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
        depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
        depth.depthCompareOp = VK_COMPARE_OP_GREATER;
        written.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                 VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        blend.attachmentCount = 1;
        blend.pAttachments = &written;
        dynamic.dynamicStateCount = static_cast<std::uint32_t>(states.size());
        dynamic.pDynamicStates = states.data();
    }
    CommonState(const CommonState&) = delete;
    CommonState& operator=(const CommonState&) = delete;

    void apply_to(VkGraphicsPipelineCreateInfo& info) const
    {
        info.pInputAssemblyState = &assembly;
        info.pViewportState = &viewport;
        info.pRasterizationState = &raster;
        info.pMultisampleState = &samples;
        info.pDepthStencilState = &depth;
        info.pColorBlendState = &blend;
        info.pDynamicState = &dynamic;
    }
};

} // namespace

Pipeline::~Pipeline()
{
    device_.call().vkDestroyPipeline(device_.handle(), pipeline_, nullptr);
}

ComputePipeline::ComputePipeline(const PipelineCache& cache, const ShaderLayout& layout, Spirv code,
                                 Constants constants)
    : Pipeline(cache.device())
{
    const Module module(device_, code);
    const Specialization specialization(constants);
    auto info = typed<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage = stage_of(VK_SHADER_STAGE_COMPUTE_BIT, module, specialization);
    info.layout = layout.handle();
    check(device_.call().vkCreateComputePipelines(device_.handle(), cache.handle(), 1, &info, nullptr,
                                                  &pipeline_),
          "compiling a shader");
}

RasterPipeline::RasterPipeline(const PipelineCache& cache, const ShaderLayout& layout,
                               const RasterShader& shader)
    : Pipeline(cache.device())
{
    const Module vertex(device_, shader.vertex), fragment(device_, shader.fragment);
    const Specialization none({}), constants(shader.constants);
    const std::array stages = {stage_of(VK_SHADER_STAGE_VERTEX_BIT, vertex, none),
                               stage_of(VK_SHADER_STAGE_FRAGMENT_BIT, fragment, constants)};
    const VkVertexInputBindingDescription stride = {0, shader.vertex_stride, VK_VERTEX_INPUT_RATE_VERTEX};
    const VkVertexInputAttributeDescription position = {0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0};
    auto input = typed<VkPipelineVertexInputStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    input.vertexBindingDescriptionCount = input.vertexAttributeDescriptionCount = 1;
    input.pVertexBindingDescriptions = &stride;
    input.pVertexAttributeDescriptions = &position;
    auto target = typed<VkPipelineRenderingCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);
    target.colorAttachmentCount = 1;
    target.pColorAttachmentFormats = &shader.color;
    target.depthAttachmentFormat = shader.depth;
    const CommonState state;
    auto info = typed<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
    info.pNext = &target;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &input;
    state.apply_to(info);
    info.layout = layout.handle();
    check(device_.call().vkCreateGraphicsPipelines(device_.handle(), cache.handle(), 1, &info, nullptr,
                                                   &pipeline_),
          "compiling a shader");
}

} // namespace lambent::vulkan
