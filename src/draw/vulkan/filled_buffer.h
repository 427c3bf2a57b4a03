// Device buffers that are filled once, when they are made.
#pragma once

#include "vulkan/commands.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lambent::draw {

/// A buffer in the device's own memory with a copy of the parts, one after the other; at least 64 bytes, because
/// buffers cannot be empty. Throws Error(no_device).
vulkan::Buffer filled_buffer(const vulkan::Device& device, VkBufferUsageFlags usage,
                             std::span<const std::span<const std::byte>> parts);

/// The same for one array of records, as a storage buffer.
template <class Record>
vulkan::Buffer filled_buffer(const vulkan::Device& device, const std::vector<Record>& records)
{
    const std::span<const std::byte> bytes = std::as_bytes(std::span(records));
    return filled_buffer(device, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, {&bytes, 1});
}

} // namespace lambent::draw
