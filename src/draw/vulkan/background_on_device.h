// What is seen behind everything, where a device can read it.
#pragma once

#include "draw/prepared_picture.h"
#include "draw/vulkan/environment_on_device.h"
#include "gpu_layout/layout.h"

namespace lambent::draw {

/// Writes the background's part of the record; whether there is anything to be drawn. `on_device`: the picture's
/// environment, where its panorama goes if that is seen. Throws Error(no_device).
bool describe_background(const vulkan::Device& device, const PreparedPicture& picture,
                         EnvironmentOnDevice& on_device, gpu_layout::PictureRecord& record);

} // namespace lambent::draw
