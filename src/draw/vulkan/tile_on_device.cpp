#include "draw/vulkan/tile_on_device.h"

#include <algorithm>
#include <cstring>

namespace lambent::draw {
namespace {

using namespace gpu_layout;
using vulkan::MemoryKind, vulkan::TextureShape;

constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                             to = VK_BUFFER_USAGE_TRANSFER_DST_BIT, from = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;

// The shape of a render target for a tile with its apron.
TextureShape target(const TileShape& tile, VkFormat format, std::uint32_t layers, VkImageUsageFlags usage)
{
    TextureShape shape;
    shape.format = format;
    shape.width = static_cast<std::uint32_t>(tile.width + 2);
    shape.height = static_cast<std::uint32_t>(tile.height + 2);
    shape.array_layers = layers;
    shape.usage = usage;
    return shape;
}

std::size_t apron_pixels(const TileShape& s)
{
    return static_cast<std::size_t>(s.width + 2) * static_cast<std::size_t>(s.height + 2);
}

std::size_t output_bytes(const TileShape& s)
{
    return s.pixels() * static_cast<std::size_t>(1 + s.layers) * sizeof(vec4);
}

// The most pixels of a tile that fits in the device's memory.
std::size_t most_pixels(const vulkan::Device& device, int looks, int layers)
{
    constexpr std::size_t least = 4096, per_fragment = column_count * sizeof(float) + sizeof(FragmentRecord);
    const auto all_looks = static_cast<std::size_t>(looks), all_layers = static_cast<std::size_t>(1 + layers);
    const std::size_t per_pixel = 3 * per_fragment / 2 + all_looks * (2 * sizeof(uint) + sizeof(vec4)) +
                                  sizeof(uint) + 3 * sizeof(uvec4) + 2 * all_layers * sizeof(vec4);
    // Devices in software gain nothing from tiles above 256 MiB.
    const std::size_t most = device.is_software() ? std::size_t{256} << 20 : std::size_t{3} << 29;
    // The largest buffer has to fit into a binding.
    const std::size_t bound = device.properties().limits.maxStorageBufferRange / (3 * per_fragment / 2);
    return std::max(
        std::min({most / per_pixel, static_cast<std::size_t>(device.own_memory()) / 4 / per_pixel, bound}),
        least);
}

// 3/2 fragments per pixel. Tiles that need more, because all pixels are edges, are drawn in parts.
std::size_t capacity_of(const TileShape& shape)
{
    const std::size_t group = group_size;
    return std::max(3 * shape.pixels() / 2, static_cast<std::size_t>(shape.looks) * group) + group;
}

} // namespace

TileShape tile_shape(const vulkan::Device& device, const Settings& settings, int looks, int layers)
{
    constexpr int widest = 4096;
    const std::size_t pixels = most_pixels(device, looks, layers);
    TileShape shape;
    shape.width = std::min(settings.width, widest);
    shape.height = static_cast<int>(std::clamp<std::size_t>(pixels / static_cast<std::size_t>(shape.width), 1,
                                                            static_cast<std::size_t>(settings.height)));
    shape.looks = looks;
    shape.layers = layers;
    shape.capacity = capacity_of(shape);
    return shape;
}

TileShape united(const vulkan::Device& device, const TileShape& first, const TileShape& second)
{
    TileShape both;
    both.width = std::max(first.width, second.width);
    both.height = std::max(first.height, second.height);
    both.looks = std::max(first.looks, second.looks);
    both.layers = std::max(first.layers, second.layers);
    both.capacity = capacity_of(both);
    return both.pixels() <= most_pixels(device, both.looks, both.layers) ? both : first;
}

TileOnDevice::TileOnDevice(const vulkan::Device& device, const TileShape& shape)
    : shape_(shape), ids_(device, target(shape, id_format, static_cast<std::uint32_t>(shape.looks),
                                         VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT)),
      depth_(device, target(shape, depth_format, 0, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT)),
      nearest_(device, vulkan::Filter::nearest),
      values_(device, shape.capacity * column_count * sizeof(float), storage | from | to, MemoryKind::device),
      picture_(device, sizeof(PictureRecord), storage | to, MemoryKind::device),
      places_(device, static_cast<std::size_t>(std::max(shape.looks, 8)) * sizeof(glm::vec2), storage,
              MemoryKind::upload),
      seen_(device, apron_pixels(shape) * 2 * sizeof(uvec4), storage, MemoryKind::device),
      records_(device, shape.capacity * sizeof(FragmentRecord), storage, MemoryKind::device),
      spans_(device, shape.pixels() * sizeof(uvec4), storage, MemoryKind::device),
      behind_(device, shape.pixels() * static_cast<std::size_t>(shape.looks) * sizeof(vec4), storage,
              MemoryKind::device),
      counters_(device, counter_count * sizeof(uint),
                storage | from | to | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT, MemoryKind::device),
      counted_(device, counter_count * sizeof(uint), to, MemoryKind::readback),
      listed_(device, shape.pixels() * sizeof(uint), storage, MemoryKind::device),
      output_(device, output_bytes(shape), storage | from, MemoryKind::device),
      drawn_(device, output_bytes(shape), to, MemoryKind::readback)
{
    vulkan::Commands commands(device);
    commands.prepare(ids_);
    commands.prepare(depth_);
    commands.run();
}

void TileOnDevice::place_looks(std::span<const glm::vec2> places) const
{
    std::memcpy(places_.memory().data(), places.data(), places.size_bytes());
}

void TileOnDevice::offer(std::array<vulkan::Resource, binding_count>& resources) const
{
    resources[binding_fragments].buffer = &values_;
    resources[binding_picture].buffer = &picture_;
    resources[binding_places].buffer = &places_;
    resources[binding_seen].buffer = &seen_;
    resources[binding_records].buffer = &records_;
    resources[binding_spans].buffer = &spans_;
    resources[binding_behind].buffer = &behind_;
    resources[binding_counters].buffer = &counters_;
    resources[binding_listed].buffer = &listed_;
    resources[binding_output].buffer = &output_;
    resources[binding_ids] = {nullptr, &ids_, nearest_.handle()};
}

} // namespace lambent::draw
