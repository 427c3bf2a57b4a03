// Work for a device: recorded, handed over, waited for, timed.
#pragma once

#include "vulkan/pipelines.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace lambent::vulkan {

/// Groups of a dispatch along three axes.
struct Groups {
    std::uint32_t x = 1, y = 1, z = 1;
};

/// Three numbers of groups in a buffer.
struct IndirectGroups {
    const Buffer& buffer;
    VkDeviceSize offset;
};

/// Draws out of one buffer of VkDrawIndexedIndirectCommand, all culled alike.
struct DrawBatch {
    const Buffer* draws;
    std::uint32_t first = 0, count = 0;
    VkCullModeFlags cull = VK_CULL_MODE_NONE;
    VkFrontFace front = VK_FRONT_FACE_COUNTER_CLOCKWISE;
};

/// What is drawn, with what, and where to.
struct RasterTarget {
    const RasterPipeline& pipeline;
    const Buffer &vertices, &indices; ///< indices of 32 bits
    const Texture &color, &depth;
    std::uint32_t layer = 0;     ///< of color
    std::uint32_t width, height; ///< from the top left corner
    std::uint32_t clear = 0;
};

/// A place of the picture's data in a buffer, for copies.
struct LevelBytes {
    std::uint32_t level = 0;
    VkDeviceSize offset = 0; ///< of the level's first layer; the others follow without gaps
};

/// One piece of work: commands in order, each seeing all that those before it have written. What is named in it must
/// live until run() is over.
class Commands {
public:
    explicit Commands(const Device& device);
    ~Commands();
    Commands(const Commands&) = delete;
    Commands& operator=(const Commands&) = delete;

    /// Pipelines must be of the set's layout; `push`: as many bytes as it says.
    void dispatch(const ComputePipeline& pipeline, const BindingSet& set, std::span<const std::byte> push,
                  const Groups& groups);

    /// With as many groups as three numbers in `arguments` say when it comes to it.
    void dispatch_indirect(const ComputePipeline& pipeline, const BindingSet& set,
                           std::span<const std::byte> push, const IndirectGroups& arguments);

    /// Draws into one layer of `target.color`, first cleared to `clear` in all channels, with depth 0.
    void draw(const RasterTarget& target, const BindingSet& set, std::span<const std::byte> push,
              std::span<const DrawBatch> batches);

    void copy(const Buffer& from, const Buffer& to, VkDeviceSize bytes);

    /// Sets every four bytes of a buffer to `value`.
    void fill(const Buffer& buffer, std::uint32_t value);

    /// Writes a few bytes, at most 65536, into a buffer; multiples of four.
    void write(const Buffer& buffer, std::span<const std::byte> bytes, VkDeviceSize offset = 0);

    /// A texture that was never used and that is to be drawn into; what it holds is undefined.
    void prepare(const Texture& texture);

    /// Fills a texture that was never used; afterwards shaders can read it.
    void fill(const Texture& texture, const Buffer& from, std::span<const LevelBytes> levels);

    /// From here to the next lap, or to the end, is one pass of this name; at most 63.
    void lap(const std::string& name);

    /// Hands everything over, waits, and may be called once. Throws Error(no_device).
    void run();

    /// After run(): passes and the milliseconds that the device took for each; 0 where it has no clock.
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
