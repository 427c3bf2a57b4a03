// Vulkan's functions, found at run time by volk: a program that has this starts where there is no Vulkan library.
#pragma once

#include "base/error.h"

#include <volk.h>

#include <string>

namespace lambent::vulkan {

/// There is no library, no driver or no device that will do: nothing has gone wrong.
class NoSuchDevice : public Error {
public:
    explicit NoSuchDevice(const std::string& line) : Error(Failure::no_device, line) {}
};

/// Opens the Vulkan library, once for the whole program. Throws NoSuchDevice where there is none, or an old one.
void load_library();

/// Throws Error(no_device) with one line that says what was being done and why it failed, unless it went well.
void check(VkResult result, const std::string& doing);

/// What a result means, for people: "out of device memory".
const char* meaning(VkResult result);

/// A structure of Vulkan's with its type set and everything else zero.
template <class Structure>
Structure typed(VkStructureType type)
{
    Structure structure = {};
    structure.sType = type;
    return structure;
}

} // namespace lambent::vulkan
