// The Vulkan instance and its physical devices.
#pragma once

#include "vulkan/api.h"

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace lambent::vulkan {

/// Collects the messages of the validation layer from all threads.
class ValidationMessages {
public:
    void add(const char* message);
    std::vector<std::string> all() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::string> messages_;
};

/// Features that a device has, or that are to be enabled, in Vulkan's three structures.
struct Features {
    VkPhysicalDeviceFeatures2 all =
        typed<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
    VkPhysicalDeviceVulkan12Features newer =
        typed<VkPhysicalDeviceVulkan12Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
    VkPhysicalDeviceVulkan13Features newest =
        typed<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);

    /// The structures linked by pNext; invalid once this object moves.
    VkPhysicalDeviceFeatures2* chain();
};

/// A physical device that may be chosen.
struct Candidate {
    VkPhysicalDevice device = VK_NULL_HANDLE;
    std::string name;
    bool software = false;   ///< runs on the CPU (llvmpipe)
    bool fit = false;        ///< has Vulkan 1.3, a queue for graphics and compute, and the features of Device
    std::string lacks;       ///< what is missing, if not fit
    VkDeviceSize memory = 0; ///< bytes of its largest device-local heap
};

class Instance {
public:
    /// With `validation`, enables the Khronos validation layer if it is installed. Throws Error(no_device), and
    /// NoSuchDevice if there is no library or driver.
    explicit Instance(bool validation = false);
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    VkInstance handle() const { return instance_; }
    bool validated() const { return messenger_ != VK_NULL_HANDLE; }
    std::vector<std::string> validation_messages() const { return messages_.all(); }

    /// Throws Error(no_device) with the validation layer's first message, if there is one.
    void require_no_validation_messages() const;

    /// All physical devices, in Vulkan's order.
    std::vector<Candidate> devices() const;

private:
    void receive_messages();

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    ValidationMessages messages_;
};

/// Which devices may be chosen.
enum class Choice {
    hardware, ///< only hardware, which is faster than the CPU (`--backend auto`)
    any,      ///< hardware if there is any, else software (`--backend vulkan`)
};

/// The best of the devices: hardware before software, then the one with the most memory. Throws NoSuchDevice that lists
/// the devices and why each is unsuitable.
Candidate choose(const std::vector<Candidate>& devices, Choice choice);

} // namespace lambent::vulkan
