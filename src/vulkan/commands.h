// Work for a device: recorded, handed over, waited for, timed.
#pragma once

#include "vulkan/compute.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace lambent::vulkan {

/// Groups of a dispatch along three axes.
struct Groups {
    std::uint32_t x = 1, y = 1, z = 1;
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

    /// `push`: as many bytes as the pipeline takes.
    void dispatch(const ComputePipeline& pipeline, const BindingSet& set, std::span<const std::byte> push,
                  const Groups& groups);

    void copy(const Buffer& from, const Buffer& to, VkDeviceSize bytes);

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
