// Vulkan's functions, found at run time by volk: a program that has this starts where there is no Vulkan library.
#pragma once

#include <volk.h>

#include <string>

namespace lambent::vulkan {

/// Opens the Vulkan library, once for the whole program. Throws Error(no_device) where there is none, or an old one.
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
