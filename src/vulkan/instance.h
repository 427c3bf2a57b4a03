// The Vulkan library at work, and which devices it knows.
#pragma once

#include "vulkan/api.h"

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace lambent::vulkan {

/// What the validation layer has said, from any thread.
class Complaints {
public:
    void add(const char* message);
    std::vector<std::string> all() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::string> messages_;
};

/// What a device can do, or is to do, in Vulkan's own three lists.
struct Features {
    VkPhysicalDeviceFeatures2 all =
        typed<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
    VkPhysicalDeviceVulkan12Features newer =
        typed<VkPhysicalDeviceVulkan12Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
    VkPhysicalDeviceVulkan13Features newest =
        typed<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);

    /// The lists, linked; valid while this stays where it is.
    VkPhysicalDeviceFeatures2* chain();
};

/// A device that could be used.
struct Candidate {
    VkPhysicalDevice device = VK_NULL_HANDLE;
    std::string name;
    bool software = false; ///< runs on the processor (llvmpipe)
    bool fit =
        false; ///< Vulkan 1.3, with a queue for graphics and compute and all features that Device asks for
    std::string lacks;       ///< where not fit: what is missing
    VkDeviceSize memory = 0; ///< bytes of its own
};

class Instance {
public:
    /// With `validation`, the Khronos validation layer watches where it is installed. Throws Error(no_device), where there
    /// is no library or driver NoSuchDevice.
    explicit Instance(bool validation = false);
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    VkInstance handle() const { return instance_; }
    bool validated() const { return messenger_ != VK_NULL_HANDLE; }
    std::vector<std::string> complaints() const { return complaints_.all(); }

    /// Throws Error(no_device) with what the layer said first, if it said anything.
    void require_silence() const;

    /// Every device, in the library's order.
    std::vector<Candidate> devices() const;

private:
    void watch();

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    Complaints complaints_;
};

/// Which devices may be chosen.
enum class Choice {
    hardware, ///< `--backend auto`: only what is faster than the processor itself
    any,      ///< `--backend vulkan`: hardware first, else software
};

/// The best of the devices: discrete or otherwise with memory of its own first, the one with most memory, software last.
/// Throws NoSuchDevice that says what there was and why it will not do.
Candidate choose(const std::vector<Candidate>& devices, Choice choice);

} // namespace lambent::vulkan
