#include "vulkan/memory.h"

#include "base/error.h"
#include "base/text.h"

namespace lambent::vulkan {
namespace {

struct Properties {
    VkMemoryPropertyFlags needed, liked;
};

Properties properties_of(Place place)
{
    constexpr VkMemoryPropertyFlags shared =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    switch (place) {
    case Place::upload:
        return {shared, 0};
    case Place::readback: // uncached memory is read a hundred times slower
        return {shared, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
    default:
        return {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
    }
}

VkDeviceMemory allocate(const Device& device, const VkMemoryRequirements& needs, const Properties& properties)
{
    auto info = typed<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.allocationSize = needs.size;
    info.memoryTypeIndex = device.memory_type(needs.memoryTypeBits, properties.needed, properties.liked);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    check(device.call().vkAllocateMemory(device.handle(), &info, nullptr, &memory),
          text("taking ", needs.size >> 20, " MiB on ", device.name()));
    return memory;
}

} // namespace

Buffer::Buffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, Place place)
    : device_(&device), bytes_(bytes)
{
    try {
        auto info = typed<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
        info.size = bytes;
        info.usage = usage;
        check(device.call().vkCreateBuffer(device.handle(), &info, nullptr, &buffer_),
              text("making a buffer of ", bytes, " bytes"));
        VkMemoryRequirements needs;
        device.call().vkGetBufferMemoryRequirements(device.handle(), buffer_, &needs);
        memory_ = allocate(device, needs, properties_of(place));
        check(device.call().vkBindBufferMemory(device.handle(), buffer_, memory_, 0),
              "giving a buffer its memory");
        if (place != Place::device)
            check(device.call().vkMapMemory(device.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped_),
                  "reaching a buffer's memory");
    } catch (...) {
        release();
        throw;
    }
}

void Buffer::release()
{
    if (!device_)
        return;
    device_->call().vkDestroyBuffer(device_->handle(), buffer_, nullptr);
    device_->call().vkFreeMemory(device_->handle(), memory_, nullptr);
}

Buffer::~Buffer()
{
    release();
}

Texture::Texture(const Device& device, const TextureShape& shape) : device_(&device), shape_(shape)
{
    try {
        make_image();
        make_view();
    } catch (...) {
        release();
        throw;
    }
}

void Texture::make_image()
{
    const VkPhysicalDeviceLimits& limits = device_->properties().limits;
    const std::uint32_t most = shape_.cube ? limits.maxImageDimensionCube : limits.maxImageDimension2D;
    if (shape_.width > most || shape_.height > most)
        throw Error(Failure::no_device, text("Vulkan: ", device_->name(), " has no pictures of ",
                                             shape_.width, "x", shape_.height, " texels, only up to ", most));
    auto info = typed<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    if (shape_.cube)
        info.flags = VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = shape_.format;
    info.extent = {shape_.width, shape_.height, 1};
    info.mipLevels = shape_.levels;
    info.arrayLayers = layers();
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = shape_.usage;
    check(device_->call().vkCreateImage(device_->handle(), &info, nullptr, &image_), "making a picture");
    VkMemoryRequirements needs;
    device_->call().vkGetImageMemoryRequirements(device_->handle(), image_, &needs);
    memory_ = allocate(*device_, needs, properties_of(Place::device));
    check(device_->call().vkBindImageMemory(device_->handle(), image_, memory_, 0),
          "giving a picture its memory");
}

void Texture::make_view()
{
    auto info = typed<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    info.image = image_;
    info.viewType = shape_.cube ? VK_IMAGE_VIEW_TYPE_CUBE : VK_IMAGE_VIEW_TYPE_2D;
    info.format = shape_.format;
    info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, shape_.levels, 0, layers()};
    check(device_->call().vkCreateImageView(device_->handle(), &info, nullptr, &view_),
          "making a view of a picture");
}

void Texture::release()
{
    if (!device_)
        return;
    device_->call().vkDestroyImageView(device_->handle(), view_, nullptr);
    device_->call().vkDestroyImage(device_->handle(), image_, nullptr);
    device_->call().vkFreeMemory(device_->handle(), memory_, nullptr);
}

Texture::~Texture()
{
    release();
}

} // namespace lambent::vulkan
