// How the program uses Vulkan devices. Only where it was built with Vulkan.
#pragma once

#include "draw/vulkan/vulkan_renderer.h"
#include "environment/cache/environment_cache.h"

namespace lambent::cli {

/// Debug builds let the Khronos layer watch, and fail over what it says. `cache`: keep compiled shaders.
inline draw::VulkanOptions device_options(bool cache)
{
    draw::VulkanOptions options;
#ifndef NDEBUG
    options.validation = true;
#endif
    if (cache)
        options.cache_folder = environment::user_cache_folder().value_or("");
    return options;
}

} // namespace lambent::cli
