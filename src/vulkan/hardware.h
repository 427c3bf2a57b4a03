// Whether it is worth asking Vulkan for hardware at all.
#pragma once

#include <filesystem>

namespace lambent::vulkan {

/// Whether the system shows a graphics device to programs. Asking Vulkan instead loads every driver there is, software
/// ones with their compilers too, which costs more than a small picture. True where that cannot be told.
bool may_have_hardware(const std::filesystem::path& devices = "/dev");

} // namespace lambent::vulkan
