// Vulkan's functions, found at run time: a program that uses this starts where there is no Vulkan library.
#pragma once

#include <vulkan/vulkan.h>

#include <string>

namespace lambent::test {

// Functions that need no instance, those of an instance, and those of a device.
#define LAMBENT_VULKAN_GLOBAL(X)                                                                             \
    X(CreateInstance)                                                                                        \
    X(EnumerateInstanceLayerProperties)                                                                      \
    X(EnumerateInstanceVersion)

#define LAMBENT_VULKAN_INSTANCE(X)                                                                           \
    X(CreateDevice)                                                                                          \
    X(DestroyInstance)                                                                                       \
    X(EnumeratePhysicalDevices)                                                                              \
    X(GetDeviceProcAddr)                                                                                     \
    X(GetPhysicalDeviceMemoryProperties)                                                                     \
    X(GetPhysicalDeviceProperties)                                                                           \
    X(GetPhysicalDeviceQueueFamilyProperties)

#define LAMBENT_VULKAN_DEVICE(X)                                                                             \
    X(AllocateCommandBuffers)                                                                                \
    X(AllocateDescriptorSets)                                                                                \
    X(AllocateMemory)                                                                                        \
    X(BeginCommandBuffer)                                                                                    \
    X(BindBufferMemory)                                                                                      \
    X(CmdBindDescriptorSets)                                                                                 \
    X(CmdBindPipeline)                                                                                       \
    X(CmdDispatch)                                                                                           \
    X(CmdPipelineBarrier)                                                                                    \
    X(CreateBuffer)                                                                                          \
    X(CreateCommandPool)                                                                                     \
    X(CreateComputePipelines)                                                                                \
    X(CreateDescriptorPool)                                                                                  \
    X(CreateDescriptorSetLayout)                                                                             \
    X(CreatePipelineLayout)                                                                                  \
    X(CreateShaderModule)                                                                                    \
    X(DestroyBuffer)                                                                                         \
    X(DestroyCommandPool)                                                                                    \
    X(DestroyDescriptorPool)                                                                                 \
    X(DestroyDescriptorSetLayout)                                                                            \
    X(DestroyDevice)                                                                                         \
    X(DestroyPipeline)                                                                                       \
    X(DestroyPipelineLayout)                                                                                 \
    X(DestroyShaderModule)                                                                                   \
    X(EndCommandBuffer)                                                                                      \
    X(FreeMemory)                                                                                            \
    X(GetBufferMemoryRequirements)                                                                           \
    X(GetDeviceQueue)                                                                                        \
    X(MapMemory)                                                                                             \
    X(QueueSubmit)                                                                                           \
    X(QueueWaitIdle)                                                                                         \
    X(UnmapMemory)                                                                                           \
    X(UpdateDescriptorSets)

// Members are named without the vk: api.CreateBuffer(...). Of the last two groups a member is null until the
// instance or the device has been given.
struct Api {
    PFN_vkGetInstanceProcAddr GetInstanceProcAddr = nullptr;
#define X(name) PFN_vk##name name = nullptr;
    LAMBENT_VULKAN_GLOBAL(X)
    LAMBENT_VULKAN_INSTANCE(X)
    LAMBENT_VULKAN_DEVICE(X)
#undef X

    // Opens libvulkan.so.1, once for the whole program (it is never closed: drivers do not survive that).
    // False where there is none.
    bool load();
    void load_instance(VkInstance instance);
    void load_device(VkDevice device);
};

// Throws std::runtime_error that names the call, unless the result is VK_SUCCESS.
void check(VkResult result, const std::string& call);

} // namespace lambent::test
