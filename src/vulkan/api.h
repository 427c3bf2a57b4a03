// Vulkan's functions, loaded at run time by volk, so that programs start on systems without a Vulkan library.
#pragma once

#include "base/error.h"

#include <volk.h>

#include <string>

namespace lambent::vulkan {

/// The system has no Vulkan library, no driver or no suitable device. This is not a malfunction.
class NoSuchDevice : public Error {
public:
    explicit NoSuchDevice(const std::string& line) : Error(Failure::no_device, line) {}
};

/// Loads the Vulkan library, once per process. Throws NoSuchDevice if there is none or it is older than 1.3.
void load_library();

/// Throws Error(no_device) unless `result` is VK_SUCCESS, with one line that names the operation and the reason.
void check(VkResult result, const std::string& doing);

/// A result in words, for messages: "out of device memory".
const char* meaning(VkResult result);

/// A Vulkan structure with its type set and everything else zero.
template <class Structure>
Structure typed(VkStructureType type)
{
    Structure structure = {};
    structure.sType = type;
    return structure;
}

} // namespace lambent::vulkan
