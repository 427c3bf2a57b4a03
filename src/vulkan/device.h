// A logical device with one queue.
#pragma once

#include "vulkan/instance.h"

#include <memory>

namespace lambent::vulkan {

/// May be used by one thread at a time.
class Device {
public:
    /// The instance must outlive it. Throws Error(no_device).
    Device(const Instance& instance, const Candidate& candidate);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkDevice handle() const { return device_; }
    VkQueue queue() const { return queue_; }
    std::uint32_t queue_family() const { return family_; }
    const VolkDeviceTable& call() const { return table_; } ///< the device's own functions
    const std::string& name() const { return candidate_.name; }
    bool is_software() const { return candidate_.software; }
    VkDeviceSize own_memory() const { return candidate_.memory; } ///< bytes
    const VkPhysicalDeviceProperties& properties() const { return properties_; }
    VkPhysicalDevice physical() const { return candidate_.device; }

    /// Nanoseconds per step of a timestamp; 0 if the queue has no timestamps.
    double timestamp_period() const { return timestamp_period_; }

    /// Index of a memory type among the bits of `allowed` with all `needed` properties, preferably also with the
    /// `preferred` ones. Throws Error(no_device) if there is none.
    std::uint32_t memory_type(std::uint32_t allowed, VkMemoryPropertyFlags needed,
                              VkMemoryPropertyFlags preferred) const;

private:
    void find_queue_family();

    Candidate candidate_;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memory_{};
    std::uint32_t family_ = 0;
    double timestamp_period_ = 0.0;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    VolkDeviceTable table_{};
};

} // namespace lambent::vulkan
