// Commands for a device: recorded, submitted, waited for and timed.
#pragma once

#include "vulkan/pipelines.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace lambent::vulkan {

/// Number of workgroups of a dispatch along each axis.
struct Groups {
    std::uint32_t x = 1, y = 1, z = 1;
};

/// Position in a buffer of a VkDispatchIndirectCommand.
struct IndirectGroups {
    const Buffer& buffer;
    VkDeviceSize offset;
};

/// Draws `first` to `first` + `count` - 1 of a buffer of VkDrawIndexedIndirectCommand, with the same culling.
struct DrawBatch {
    const Buffer* draws;
    std::uint32_t first = 0, count = 0;
    VkCullModeFlags cull = VK_CULL_MODE_NONE;
    VkFrontFace front = VK_FRONT_FACE_COUNTER_CLOCKWISE;
};

/// Pipeline, geometry and attachments of draws.
struct RasterTarget {
    const RasterPipeline& pipeline;
    const Buffer &vertices, &indices; ///< indices have 32 bits
    const Texture &color, &depth;
    std::uint32_t layer = 0;     ///< of `color`
    std::uint32_t width, height; ///< of the area drawn, from the top left corner
    std::uint32_t clear = 0;
};

/// Position of a texture level's texels in a buffer, for copies.
struct LevelBytes {
    std::uint32_t level = 0;
    VkDeviceSize offset = 0; ///< of the level's first layer; the others follow without gaps
};

/// A command buffer whose commands run in order, each seeing all writes of those before it. The resources that it uses
/// must live until run() returns.
class Commands {
public:
    explicit Commands(const Device& device);
    ~Commands();
    Commands(const Commands&) = delete;
    Commands& operator=(const Commands&) = delete;

    /// The pipeline must have the set's layout, and `push` as many bytes as that layout's push constants.
    void dispatch(const ComputePipeline& pipeline, const BindingSet& set, std::span<const std::byte> push,
                  const Groups& groups);

    /// The same with the number of workgroups read from a buffer when the command runs.
    void dispatch_indirect(const ComputePipeline& pipeline, const BindingSet& set,
                           std::span<const std::byte> push, const IndirectGroups& arguments);

    /// Clears one layer of `target.color` to `target.clear` in all channels and the depth to 0, then draws into them.
    void draw(const RasterTarget& target, const BindingSet& set, std::span<const std::byte> push,
              std::span<const DrawBatch> batches);

    void copy(const Buffer& from, const Buffer& to, VkDeviceSize bytes);

    /// Sets every four bytes of a buffer to `value`.
    void fill(const Buffer& buffer, std::uint32_t value);

    /// Writes at most 65536 bytes into a buffer; their number and the offset are multiples of four.
    void write(const Buffer& buffer, std::span<const std::byte> bytes, VkDeviceSize offset = 0);

    /// Prepares an unused texture as a render target; its content becomes undefined.
    void prepare(const Texture& texture);

    /// Fills an unused texture; afterwards shaders can read it.
    void fill(const Texture& texture, const Buffer& from, std::span<const LevelBytes> levels);

    /// Begins a timed pass with this name, which ends at the next lap() or with the commands. Throws std::length_error
    /// for more than 63.
    void lap(const std::string& name);

    /// Submits the commands and waits until they are done. May be called once. Throws Error(no_device).
    void run();

    /// After run(): the passes and the milliseconds that each took on the device; 0 on a device without timestamps.
    std::vector<std::pair<std::string, double>> laps() const;

private:
    void barrier() const;
    void bind(VkPipelineBindPoint point, const Pipeline& pipeline, const BindingSet& set,
              std::span<const std::byte> push) const;
    void stamp(std::uint32_t index) const;

    static constexpr std::uint32_t most_laps = 63;

    const Device& device_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer buffer_ = VK_NULL_HANDLE;
    VkQueryPool clock_ = VK_NULL_HANDLE;
    std::vector<std::string> names_;
    std::vector<std::uint64_t> stamps_;
};

} // namespace lambent::vulkan
