// Options of Vulkan devices. Only included in programs built with Vulkan.
#pragma once

#include "draw/vulkan/vulkan_renderer.h"
#include "environment/cache/environment_cache.h"

namespace lambent::cli {

/// Debug builds use the Khronos validation layer and fail on its messages. `cache`: keep compiled shaders.
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
