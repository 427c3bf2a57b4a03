#include "draw/vulkan/filled_buffer.h"

#include <algorithm>
#include <cstring>

namespace lambent::draw {

vulkan::Buffer filled_buffer(const vulkan::Device& device, VkBufferUsageFlags usage,
                             std::span<const std::span<const std::byte>> parts)
{
    constexpr std::size_t least = 64;
    std::size_t bytes = 0;
    for (const std::span<const std::byte>& part : parts)
        bytes += part.size();
    vulkan::Buffer buffer(device, std::max(bytes, least), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                          vulkan::MemoryKind::device);
    if (bytes == 0)
        return buffer;
    const vulkan::Buffer staging(device, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, vulkan::MemoryKind::upload);
    std::byte* to = staging.memory().data();
    for (const std::span<const std::byte>& part : parts) {
        if (!part.empty())
            std::memcpy(to, part.data(), part.size());
        to += part.size();
    }
    vulkan::Commands commands(device);
    commands.copy(staging, buffer, bytes);
    commands.run();
    return buffer;
}

} // namespace lambent::draw
