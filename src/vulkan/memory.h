// Buffers and textures on a device. Their constructors throw Error(no_device) when memory runs out.
#pragma once

#include "vulkan/device.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace lambent::vulkan {

/// The memory that a buffer is in, by who reads and writes it.
enum class MemoryKind {
    device,   ///< only the device; filled and read by copies
    upload,   ///< written by the CPU, read by the device
    readback, ///< written by the device, read by the CPU
};

class Buffer {
public:
    /// `bytes` is greater than 0.
    Buffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, MemoryKind kind);
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~Buffer();

    VkBuffer handle() const { return buffer_; }
    VkDeviceSize bytes() const { return bytes_; }

    /// The address for shaders; only with VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT.
    VkDeviceAddress address() const;

    /// The mapped memory; not for MemoryKind::device.
    std::span<std::byte> memory() const { return {static_cast<std::byte*>(mapped_), bytes_}; }

private:
    void swap(Buffer& other) noexcept
    {
        std::swap(device_, other.device_);
        std::swap(buffer_, other.buffer_);
        std::swap(memory_, other.memory_);
        std::swap(bytes_, other.bytes_);
        std::swap(mapped_, other.mapped_);
    }
    void release();

    const Device* device_ = nullptr;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    VkDeviceSize bytes_ = 0;
    void* mapped_ = nullptr;
};

struct TextureShape {
    VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
    std::uint32_t width = 1, height = 1;
    std::uint32_t levels = 1;
    bool cube = false; ///< six layers, viewed as a cube map
    std::uint32_t array_layers =
        0; ///< number of layers, viewed as a 2D array; 0: one layer, viewed as a 2D image
    VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
};

class Texture {
public:
    Texture(const Device& device, const TextureShape& shape);
    Texture(Texture&& other) noexcept { swap(other); }
    Texture& operator=(Texture&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~Texture();

    VkImage image() const { return image_; }
    VkImageView view() const { return view_; }
    const TextureShape& shape() const { return shape_; }
    VkImageView layer_view(std::uint32_t layer) const { return layer_views_[layer]; } ///< of a render target
    std::uint32_t layers() const { return shape_.cube ? 6 : std::max(shape_.array_layers, 1u); }
    VkImageAspectFlags aspect() const;

private:
    void swap(Texture& other) noexcept
    {
        std::swap(device_, other.device_);
        std::swap(image_, other.image_);
        std::swap(view_, other.view_);
        std::swap(layer_views_, other.layer_views_);
        std::swap(memory_, other.memory_);
        std::swap(shape_, other.shape_);
    }
    void make_image();
    VkImageView make_view(VkImageViewType type, std::uint32_t first_layer, std::uint32_t count) const;
    void release();

    const Device* device_ = nullptr;
    VkImage image_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    std::vector<VkImageView> layer_views_; ///< one per layer of a render target, else empty
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    TextureShape shape_;
};

} // namespace lambent::vulkan
