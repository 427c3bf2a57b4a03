// A cheap test for graphics hardware, made before Vulkan is loaded.
#pragma once

#include <filesystem>

namespace lambent::vulkan {

/// Whether the system offers a graphics device to programs; true if unknown. Asking Vulkan loads every installed
/// driver, software ones with their compilers included, which takes longer than drawing a small image.
bool may_have_hardware(const std::filesystem::path& devices = "/dev");

} // namespace lambent::vulkan
