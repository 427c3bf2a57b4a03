// What all fragments of a picture share, where a device can read it.
#pragma once

#include "draw/prepared_picture.h"
#include "gpu_layout/layout.h"
#include "vulkan/commands.h"

#include <array>
#include <optional>
#include <span>

namespace lambent::draw {

/// Lights and tables of points. Throws Error(no_device).
class PictureOnDevice {
public:
    /// The device must outlive it. Nothing is kept of the others.
    PictureOnDevice(const vulkan::Device& device, const LightContext& context,
                    std::span<const LightSource> lights);

    /// Puts what it holds where shaders look for it.
    void offer(std::array<vulkan::Resource, gpu_layout::binding_count>& resources) const;

    /// What light depends on; rays, tile and background are left to the caller.
    const gpu_layout::PictureRecord& record() const { return record_; }

private:
    gpu_layout::PictureRecord record_{};
    vulkan::Buffer lights_, samples_, lamps_, albedo_;
};

} // namespace lambent::draw
