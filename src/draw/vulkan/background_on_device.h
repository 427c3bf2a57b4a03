// What is seen behind everything, where a device can read it.
#pragma once

#include "draw/prepared_picture.h"
#include "gpu_layout/layout.h"
#include "vulkan/commands.h"

#include <optional>

namespace lambent::draw {

/// Throws Error(no_device).
class BackgroundOnDevice {
public:
    /// Writes the background's part of the record. The device must outlive it.
    BackgroundOnDevice(const vulkan::Device& device, const PreparedPicture& picture,
                       gpu_layout::PictureRecord& record);

    /// Whether there is anything to be drawn.
    bool visible() const { return visible_; }

private:
    std::optional<vulkan::Buffer> panorama_; ///< read by address
    bool visible_ = false;
};

} // namespace lambent::draw
