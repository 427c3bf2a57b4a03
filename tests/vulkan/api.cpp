#include "tests/vulkan/api.h"

#include <dlfcn.h>

#include <stdexcept>

namespace lambent::test {

bool Api::load()
{
    static void* const library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return false;
    GetInstanceProcAddr =
        reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library, "vkGetInstanceProcAddr"));
    if (!GetInstanceProcAddr)
        return false;
#define X(name) name = reinterpret_cast<PFN_vk##name>(GetInstanceProcAddr(nullptr, "vk" #name));
    LAMBENT_VULKAN_GLOBAL(X)
#undef X
    return CreateInstance && EnumerateInstanceLayerProperties && EnumerateInstanceVersion; // 1.1 has the last
}

void Api::load_instance(VkInstance instance)
{
#define X(name) name = reinterpret_cast<PFN_vk##name>(GetInstanceProcAddr(instance, "vk" #name));
    LAMBENT_VULKAN_INSTANCE(X)
#undef X
}

void Api::load_device(VkDevice device)
{
#define X(name) name = reinterpret_cast<PFN_vk##name>(GetDeviceProcAddr(device, "vk" #name));
    LAMBENT_VULKAN_DEVICE(X)
#undef X
}

void check(VkResult result, const std::string& call)
{
    if (result != VK_SUCCESS)
        throw std::runtime_error(call + " failed with VkResult " + std::to_string(static_cast<int>(result)));
}

} // namespace lambent::test
