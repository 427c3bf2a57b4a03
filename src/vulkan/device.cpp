#include "vulkan/device.h"

#include "base/error.h"
#include "base/text.h"

#include <vector>

namespace lambent::vulkan {

void Device::find_queue_family()
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(candidate_.device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(candidate_.device, &count, families.data());
    constexpr VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < count; ++i)
        if ((families[i].queueFlags & wanted) == wanted) {
            family_ = i;
            if (families[i].timestampValidBits > 0)
                timestamp_period_ = static_cast<double>(properties_.limits.timestampPeriod);
            return;
        }
    throw Error(Failure::no_device,
                text("Vulkan: ", candidate_.name, " has no queue for graphics and compute"));
}

Device::Device(const Instance&, const Candidate& candidate) : candidate_(candidate)
{
    vkGetPhysicalDeviceProperties(candidate_.device, &properties_);
    vkGetPhysicalDeviceMemoryProperties(candidate_.device, &memory_);
    find_queue_family();
    const float priority = 1.0f;
    auto queue = typed<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queue.queueFamilyIndex = family_;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    Features features;
    features.newest.dynamicRendering = features.newest.synchronization2 = VK_TRUE;
    features.newer.bufferDeviceAddress = VK_TRUE;
    // Fragment shaders need the geometry shader feature to read gl_PrimitiveID.
    features.all.features.geometryShader = features.all.features.multiDrawIndirect =
        features.all.features.drawIndirectFirstInstance = VK_TRUE;
    auto info = typed<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    info.pNext = features.chain();
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    check(vkCreateDevice(candidate_.device, &info, nullptr, &device_), text("starting ", candidate_.name));
    volkLoadDeviceTable(&table_, device_);
    table_.vkGetDeviceQueue(device_, family_, 0, &queue_);
}

Device::~Device()
{
    table_.vkDeviceWaitIdle(device_); // the error of a lost device is ignored
    table_.vkDestroyDevice(device_, nullptr);
}

std::uint32_t Device::memory_type(std::uint32_t allowed, VkMemoryPropertyFlags needed,
                                  VkMemoryPropertyFlags preferred) const
{
    for (const VkMemoryPropertyFlags wanted : {needed | preferred, needed})
        for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i)
            if ((allowed & (1u << i)) != 0 && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted)
                return i;
    throw Error(Failure::no_device,
                text("Vulkan: ", candidate_.name, " has no memory with the needed properties"));
}

} // namespace lambent::vulkan
