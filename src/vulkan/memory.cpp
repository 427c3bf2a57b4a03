#include "vulkan/memory.h"

#include "base/error.h"
#include "base/text.h"

namespace lambent::vulkan {
namespace {

struct Properties {
    VkMemoryPropertyFlags needed, preferred;
};

Properties properties_of(MemoryKind kind)
{
    constexpr VkMemoryPropertyFlags shared =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    switch (kind) {
    case MemoryKind::upload:
        return {shared, 0};
    case MemoryKind::readback: // uncached memory is read a hundred times slower
        return {shared, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
    default:
        return {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
    }
}

VkDeviceMemory allocate(const Device& device, const VkMemoryRequirements& needs, const Properties& properties,
                        bool with_address = false)
{
    auto flags = typed<VkMemoryAllocateFlagsInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO);
    flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
    auto info = typed<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.pNext = with_address ? &flags : nullptr;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = device.memory_type(needs.memoryTypeBits, properties.needed, properties.preferred);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    check(device.call().vkAllocateMemory(device.handle(), &info, nullptr, &memory),
          text("allocating ", needs.size >> 20, " MiB on ", device.name()));
    return memory;
}

} // namespace

Buffer::Buffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, MemoryKind kind)
    : device_(&device), bytes_(bytes)
{
    try {
        auto info = typed<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
        info.size = bytes;
        info.usage = usage;
        check(device.call().vkCreateBuffer(device.handle(), &info, nullptr, &buffer_),
              text("creating a buffer of ", bytes, " bytes"));
        VkMemoryRequirements needs;
        device.call().vkGetBufferMemoryRequirements(device.handle(), buffer_, &needs);
        memory_ = allocate(device, needs, properties_of(kind),
                           (usage & VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT) != 0);
        check(device.call().vkBindBufferMemory(device.handle(), buffer_, memory_, 0),
              "binding the memory of a buffer");
        if (kind != MemoryKind::device)
            check(device.call().vkMapMemory(device.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped_),
                  "mapping the memory of a buffer");
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

VkDeviceAddress Buffer::address() const
{
    auto info = typed<VkBufferDeviceAddressInfo>(VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO);
    info.buffer = buffer_;
    return device_->call().vkGetBufferDeviceAddress(device_->handle(), &info);
}

Texture::Texture(const Device& device, const TextureShape& shape) : device_(&device), shape_(shape)
{
    constexpr VkImageUsageFlags drawn =
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    try {
        make_image();
        const VkImageViewType flat =
            shape.array_layers > 0 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
        view_ = make_view(shape.cube ? VK_IMAGE_VIEW_TYPE_CUBE : flat, 0, layers());
        for (std::uint32_t layer = 0; (shape.usage & drawn) != 0 && layer < layers(); ++layer)
            layer_views_.push_back(make_view(VK_IMAGE_VIEW_TYPE_2D, layer, 1));
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
        throw Error(Failure::no_device, text("Vulkan: ", device_->name(), " has no images of ", shape_.width,
                                             "x", shape_.height, " texels, only up to ", most));
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
    check(device_->call().vkCreateImage(device_->handle(), &info, nullptr, &image_), "creating an image");
    VkMemoryRequirements needs;
    device_->call().vkGetImageMemoryRequirements(device_->handle(), image_, &needs);
    memory_ = allocate(*device_, needs, properties_of(MemoryKind::device));
    check(device_->call().vkBindImageMemory(device_->handle(), image_, memory_, 0),
          "binding the memory of an image");
}

VkImageAspectFlags Texture::aspect() const
{
    return shape_.format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VkImageView Texture::make_view(VkImageViewType type, std::uint32_t first_layer, std::uint32_t count) const
{
    auto info = typed<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    info.image = image_;
    info.viewType = type;
    info.format = shape_.format;
    info.subresourceRange = {aspect(), 0, shape_.levels, first_layer, count};
    VkImageView view = VK_NULL_HANDLE;
    check(device_->call().vkCreateImageView(device_->handle(), &info, nullptr, &view),
          "creating an image view");
    return view;
}

void Texture::release()
{
    if (!device_)
        return;
    for (VkImageView view : layer_views_)
        device_->call().vkDestroyImageView(device_->handle(), view, nullptr);
    device_->call().vkDestroyImageView(device_->handle(), view_, nullptr);
    device_->call().vkDestroyImage(device_->handle(), image_, nullptr);
    device_->call().vkFreeMemory(device_->handle(), memory_, nullptr);
}

Texture::~Texture()
{
    release();
}

} // namespace lambent::vulkan
