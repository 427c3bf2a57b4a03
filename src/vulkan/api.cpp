#include "vulkan/api.h"

#include "base/text.h"

namespace lambent::vulkan {

void load_library()
{
    static const VkResult result = volkInitialize(); // never unloaded: some drivers crash when they are
    if (result != VK_SUCCESS)
        throw NoSuchDevice("Vulkan: there is no library libvulkan.so.1");
    if (volkGetInstanceVersion() < VK_API_VERSION_1_3)
        throw NoSuchDevice("Vulkan: the library is older than 1.3");
}

const char* meaning(VkResult result)
{
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "out of memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "the driver could not be started";
    case VK_ERROR_DEVICE_LOST:
        return "the device was lost";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
        return "no driver is installed";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
        return "an extension is missing";
    case VK_ERROR_FEATURE_NOT_PRESENT:
        return "a feature is missing";
    case VK_ERROR_LAYER_NOT_PRESENT:
        return "a layer is missing";
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
        return "a format is not supported";
    case VK_ERROR_TOO_MANY_OBJECTS:
        return "too many objects";
    case VK_TIMEOUT:
        return "it took too long";
    default:
        return "it failed";
    }
}

void check(VkResult result, const std::string& doing)
{
    if (result != VK_SUCCESS)
        throw Error(Failure::no_device,
                    text("Vulkan: ", doing, ": ", meaning(result), " (", static_cast<int>(result), ")"));
}

} // namespace lambent::vulkan
