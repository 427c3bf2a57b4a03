// Data shared by all fragments of a picture, in the memory of a device.
#pragma once

#include "draw/prepared_picture.h"
#include "gpu_layout/layout.h"
#include "vulkan/commands.h"

#include <array>
#include <optional>
#include <span>

namespace lambent::draw {

/// Lights, lamps, sample tables and the albedo table. Throws Error(no_device).
class PictureOnDevice {
public:
    /// `few_tables`: of small fragments. The device must outlive this; the other arguments are copied.
    PictureOnDevice(const vulkan::Device& device, const LightContext& context, const SampleTables& few_tables,
                    std::span<const LightSource> lights);

    /// Sets the buffers at their bindings.
    void offer(std::array<vulkan::Resource, gpu_layout::binding_count>& resources) const;

    /// The record with the inputs of the light passes; the caller adds rays, tile, background and layers.
    const gpu_layout::PictureRecord& record() const { return record_; }

private:
    gpu_layout::PictureRecord record_{};
    vulkan::Buffer lights_, samples_, lamps_, albedo_;
};

} // namespace lambent::draw
