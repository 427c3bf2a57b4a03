#include "vulkan/commands.h"

#include <algorithm>
#include <stdexcept>

namespace lambent::vulkan {
namespace {

constexpr std::uint64_t longest_wait =
    60'000'000'000; // nanoseconds; a submission normally takes about a second

VkImageMemoryBarrier2 whole(const Texture& texture)
{
    auto barrier = typed<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2);
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = texture.image();
    barrier.subresourceRange = {texture.aspect(), 0, texture.shape().levels, 0, texture.layers()};
    return barrier;
}

} // namespace

Commands::Commands(const Device& device) : device_(device)
{
    auto pool = typed<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    pool.queueFamilyIndex = device.queue_family();
    check(device.call().vkCreateCommandPool(device.handle(), &pool, nullptr, &pool_),
          "creating a command pool");
    try {
        auto info = typed<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
        info.commandPool = pool_;
        info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        info.commandBufferCount = 1;
        check(device.call().vkAllocateCommandBuffers(device.handle(), &info, &buffer_),
              "allocating a command buffer");
        auto begin = typed<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
        begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
        check(device.call().vkBeginCommandBuffer(buffer_, &begin), "beginning a command buffer");
        if (device.timestamp_period() > 0.0) {
            auto clock = typed<VkQueryPoolCreateInfo>(VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO);
            clock.queryType = VK_QUERY_TYPE_TIMESTAMP;
            clock.queryCount = most_laps + 1;
            check(device.call().vkCreateQueryPool(device.handle(), &clock, nullptr, &clock_),
                  "creating timestamp queries");
            device.call().vkCmdResetQueryPool(buffer_, clock_, 0, most_laps + 1);
        }
    } catch (...) {
        device.call().vkDestroyCommandPool(device.handle(), pool_, nullptr);
        throw;
    }
}

Commands::~Commands()
{
    device_.call().vkDestroyQueryPool(device_.handle(), clock_, nullptr);
    device_.call().vkDestroyCommandPool(device_.handle(), pool_, nullptr);
}

// Makes all writes before it visible to all commands after it. The commands form a chain of large, dependent steps, so
// that finer barriers would gain nothing.
void Commands::barrier() const
{
    auto memory = typed<VkMemoryBarrier2>(VK_STRUCTURE_TYPE_MEMORY_BARRIER_2);
    memory.srcStageMask = memory.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    memory.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    memory.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    auto info = typed<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &memory;
    device_.call().vkCmdPipelineBarrier2(buffer_, &info);
}

void Commands::stamp(std::uint32_t index) const
{
    if (clock_ != VK_NULL_HANDLE)
        device_.call().vkCmdWriteTimestamp2(buffer_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, clock_, index);
}

void Commands::bind(VkPipelineBindPoint point, const Pipeline& pipeline, const BindingSet& set,
                    std::span<const std::byte> push) const
{
    const ShaderLayout& layout = set.layout();
    if (push.size() != layout.push_bytes())
        throw std::invalid_argument("the size of the push constants differs from that of the layout");
    const VolkDeviceTable& call = device_.call();
    const VkDescriptorSet handle = set.handle();
    call.vkCmdBindPipeline(buffer_, point, pipeline.handle());
    call.vkCmdBindDescriptorSets(buffer_, point, layout.handle(), 0, 1, &handle, 0, nullptr);
    if (!push.empty())
        call.vkCmdPushConstants(buffer_, layout.handle(), ShaderLayout::stages, 0,
                                static_cast<std::uint32_t>(push.size()), push.data());
}

void Commands::dispatch(const ComputePipeline& pipeline, const BindingSet& set,
                        std::span<const std::byte> push, const Groups& groups)
{
    bind(VK_PIPELINE_BIND_POINT_COMPUTE, pipeline, set, push);
    device_.call().vkCmdDispatch(buffer_, groups.x, groups.y, groups.z);
    barrier();
}

void Commands::dispatch_indirect(const ComputePipeline& pipeline, const BindingSet& set,
                                 std::span<const std::byte> push, const IndirectGroups& arguments)
{
    bind(VK_PIPELINE_BIND_POINT_COMPUTE, pipeline, set, push);
    device_.call().vkCmdDispatchIndirect(buffer_, arguments.buffer.handle(), arguments.offset);
    barrier();
}

void Commands::draw(const RasterTarget& target, const BindingSet& set, std::span<const std::byte> push,
                    std::span<const DrawBatch> batches)
{
    const VolkDeviceTable& call = device_.call();
    auto color = typed<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
    color.imageView = target.color.layer_view(target.layer);
    color.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
    color.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    std::fill_n(color.clearValue.color.uint32, 4, target.clear);
    VkRenderingAttachmentInfo depth = color;
    depth.imageView = target.depth.layer_view(0);
    depth.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    depth.clearValue.depthStencil = {0.0f, 0};
    const VkRect2D area = {{0, 0}, {target.width, target.height}};
    auto info = typed<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
    info.renderArea = area;
    info.layerCount = info.colorAttachmentCount = 1;
    info.pColorAttachments = &color;
    info.pDepthAttachment = &depth;
    const VkViewport viewport = {
        0.0f, 0.0f, static_cast<float>(target.width), static_cast<float>(target.height), 0.0f, 1.0f};
    const VkBuffer vertices = target.vertices.handle();
    const VkDeviceSize beginning = 0;
    call.vkCmdBeginRendering(buffer_, &info);
    bind(VK_PIPELINE_BIND_POINT_GRAPHICS, target.pipeline, set, push);
    call.vkCmdSetViewport(buffer_, 0, 1, &viewport);
    call.vkCmdSetScissor(buffer_, 0, 1, &area);
    call.vkCmdBindVertexBuffers(buffer_, 0, 1, &vertices, &beginning);
    call.vkCmdBindIndexBuffer(buffer_, target.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
    constexpr std::uint32_t stride = sizeof(VkDrawIndexedIndirectCommand);
    const std::uint32_t at_once = device_.properties().limits.maxDrawIndirectCount;
    for (const DrawBatch& batch : batches) {
        call.vkCmdSetCullMode(buffer_, batch.cull);
        call.vkCmdSetFrontFace(buffer_, batch.front);
        const std::uint32_t end = batch.first + batch.count;
        for (std::uint32_t first = batch.first; first < end; first += at_once)
            call.vkCmdDrawIndexedIndirect(buffer_, batch.draws->handle(), VkDeviceSize{first} * stride,
                                          std::min(end - first, at_once), stride);
    }
    call.vkCmdEndRendering(buffer_);
    barrier();
}

void Commands::fill(const Buffer& buffer, std::uint32_t value)
{
    device_.call().vkCmdFillBuffer(buffer_, buffer.handle(), 0, VK_WHOLE_SIZE, value);
    barrier();
}

void Commands::write(const Buffer& buffer, std::span<const std::byte> bytes, VkDeviceSize offset)
{
    device_.call().vkCmdUpdateBuffer(buffer_, buffer.handle(), offset, bytes.size(), bytes.data());
    barrier();
}

void Commands::prepare(const Texture& texture)
{
    auto info = typed<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    info.imageMemoryBarrierCount = 1;
    VkImageMemoryBarrier2 barrier = whole(texture);
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    info.pImageMemoryBarriers = &barrier;
    device_.call().vkCmdPipelineBarrier2(buffer_, &info);
}

void Commands::copy(const Buffer& from, const Buffer& to, VkDeviceSize bytes)
{
    const VkBufferCopy region = {0, 0, bytes};
    device_.call().vkCmdCopyBuffer(buffer_, from.handle(), to.handle(), 1, &region);
    barrier();
}

void Commands::fill(const Texture& texture, const Buffer& from, std::span<const LevelBytes> levels)
{
    auto info = typed<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    info.imageMemoryBarrierCount = 1;
    VkImageMemoryBarrier2 before = whole(texture);
    before.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    before.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    before.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    info.pImageMemoryBarriers = &before;
    device_.call().vkCmdPipelineBarrier2(buffer_, &info);
    std::vector<VkBufferImageCopy> regions;
    for (const LevelBytes& part : levels) {
        VkBufferImageCopy region{};
        region.bufferOffset = part.offset;
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, part.level, 0, texture.layers()};
        region.imageExtent = {std::max(texture.shape().width >> part.level, 1u),
                              std::max(texture.shape().height >> part.level, 1u), 1};
        regions.push_back(region);
    }
    device_.call().vkCmdCopyBufferToImage(buffer_, from.handle(), texture.image(),
                                          VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                          static_cast<std::uint32_t>(regions.size()), regions.data());
    VkImageMemoryBarrier2 after = whole(texture);
    after.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    after.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    after.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    after.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    after.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    after.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    info.pImageMemoryBarriers = &after;
    device_.call().vkCmdPipelineBarrier2(buffer_, &info);
}

void Commands::lap(const std::string& name)
{
    if (names_.size() >= most_laps)
        throw std::length_error("more timed passes than timestamps");
    stamp(static_cast<std::uint32_t>(names_.size()));
    names_.push_back(name);
}

void Commands::run()
{
    const VolkDeviceTable& call = device_.call();
    stamp(static_cast<std::uint32_t>(names_.size()));
    check(call.vkEndCommandBuffer(buffer_), "ending a command buffer");
    auto info = typed<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
    VkFence fence = VK_NULL_HANDLE;
    check(call.vkCreateFence(device_.handle(), &info, nullptr, &fence), "creating a fence");
    auto commands = typed<VkCommandBufferSubmitInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO);
    commands.commandBuffer = buffer_;
    auto submit = typed<VkSubmitInfo2>(VK_STRUCTURE_TYPE_SUBMIT_INFO_2);
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &commands;
    VkResult result = call.vkQueueSubmit2(device_.queue(), 1, &submit, fence);
    if (result == VK_SUCCESS)
        result = call.vkWaitForFences(device_.handle(), 1, &fence, VK_TRUE, longest_wait);
    if (result == VK_TIMEOUT) // memory must not be freed under commands that still run
        call.vkDeviceWaitIdle(device_.handle());
    call.vkDestroyFence(device_.handle(), fence, nullptr);
    check(result, "running commands on " + device_.name());
    if (clock_ == VK_NULL_HANDLE)
        return;
    stamps_.resize(names_.size() + 1);
    check(call.vkGetQueryPoolResults(device_.handle(), clock_, 0, static_cast<std::uint32_t>(stamps_.size()),
                                     stamps_.size() * sizeof(std::uint64_t), stamps_.data(),
                                     sizeof(std::uint64_t),
                                     VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "reading timestamps");
}

std::vector<std::pair<std::string, double>> Commands::laps() const
{
    std::vector<std::pair<std::string, double>> laps;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const double steps = i + 1 < stamps_.size() ? static_cast<double>(stamps_[i + 1] - stamps_[i]) : 0.0;
        laps.emplace_back(names_[i], steps * device_.timestamp_period() * 1e-6);
    }
    return laps;
}

} // namespace lambent::vulkan
