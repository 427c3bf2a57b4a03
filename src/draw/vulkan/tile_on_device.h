// The buffers and render targets of one tile of a picture, on a device.
#pragma once

#include "draw/vulkan/passes.h"
#include "draw/vulkan/picture_on_device.h"
#include "draw/vulkan/scene_on_device.h"

#include <array>
#include <cstddef>
#include <memory>

namespace lambent::draw {

/// The size of a tile and of its buffers.
struct TileShape {
    int width = 1, height = 1; ///< pixels
    int looks = 1;             ///< per pixel
    int layers = 0;            ///< images besides the picture itself
    std::size_t capacity = 1;  ///< in fragments

    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }

    /// Whether buffers of this shape suffice for `other`.
    bool covers(const TileShape& other) const
    {
        return width >= other.width && height >= other.height && looks >= other.looks &&
               layers >= other.layers && capacity >= other.capacity;
    }
};

/// The largest tile of a picture that fits in the device's memory.
TileShape tile_shape(const vulkan::Device& device, const Settings& settings, int looks, int layers);

/// A shape that covers both if it fits in the device's memory; else `first`.
TileShape united(const vulkan::Device& device, const TileShape& first, const TileShape& second);

/// Throws Error(no_device).
class TileOnDevice {
public:
    /// The device must outlive it.
    TileOnDevice(const vulkan::Device& device, const TileShape& shape);

    const TileShape& shape() const { return shape_; }

    /// Sets the buffers at their bindings.
    void offer(std::array<vulkan::Resource, gpu_layout::binding_count>& resources) const;

    const vulkan::Texture& ids() const { return ids_; }
    const vulkan::Texture& depth() const { return depth_; }
    const vulkan::Buffer& values() const { return values_; }
    const vulkan::Buffer& picture() const { return picture_; }
    const vulkan::Buffer& counters() const { return counters_; }
    const vulkan::Buffer& counted() const { return counted_; } ///< a copy of counters() for the host
    const vulkan::Buffer& output() const { return output_; }
    const vulkan::Buffer& drawn() const { return drawn_; } ///< a copy of output() for the host

    /// Stores the positions of the looks in a pixel.
    void place_looks(std::span<const glm::vec2> places) const;

private:
    TileShape shape_;
    vulkan::Texture ids_, depth_;
    vulkan::SamplerObject nearest_;
    vulkan::Buffer values_, picture_, places_, seen_, records_, spans_, behind_, counters_, counted_, listed_,
        output_, drawn_;
};

} // namespace lambent::draw
