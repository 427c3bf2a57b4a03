// Room on a device for one tile of a picture.
#pragma once

#include "draw/vulkan/passes.h"
#include "draw/vulkan/picture_on_device.h"
#include "draw/vulkan/scene_on_device.h"

#include <array>
#include <cstddef>
#include <memory>

namespace lambent::draw {

/// How large tiles get.
struct TileShape {
    int width = 1, height = 1; ///< pixels
    int looks = 1;             ///< per pixel
    int layers = 0;            ///< besides the picture
    std::size_t capacity = 1;  ///< fragments

    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }

    /// Whether what needs another fits, too.
    bool covers(const TileShape& other) const
    {
        return width >= other.width && height >= other.height && looks >= other.looks &&
               layers >= other.layers && capacity >= other.capacity;
    }
};

/// The largest tiles of a picture that suit a device's memory.
TileShape tile_shape(const vulkan::Device& device, const Settings& settings, int looks, int layers);

/// One that covers both if it suits the device's memory, too; else the first.
TileShape united(const vulkan::Device& device, const TileShape& first, const TileShape& second);

/// Throws Error(no_device).
class TileOnDevice {
public:
    /// The device must outlive it.
    TileOnDevice(const vulkan::Device& device, const TileShape& shape);

    const TileShape& shape() const { return shape_; }

    /// Puts the buffers where shaders look for them.
    void offer(std::array<vulkan::Resource, gpu_layout::binding_count>& resources) const;

    const vulkan::Texture& ids() const { return ids_; }
    const vulkan::Texture& depth() const { return depth_; }
    const vulkan::Buffer& values() const { return values_; }
    const vulkan::Buffer& picture() const { return picture_; }
    const vulkan::Buffer& counters() const { return counters_; }
    const vulkan::Buffer& counted() const { return counted_; } ///< to be read here
    const vulkan::Buffer& output() const { return output_; }
    const vulkan::Buffer& drawn() const { return drawn_; } ///< to be read here
    void place_looks(std::span<const glm::vec2> places) const;

private:
    TileShape shape_;
    vulkan::Texture ids_, depth_;
    vulkan::SamplerObject nearest_;
    vulkan::Buffer values_, picture_, places_, seen_, records_, spans_, behind_, counters_, counted_, listed_,
        output_, drawn_;
};

} // namespace lambent::draw
