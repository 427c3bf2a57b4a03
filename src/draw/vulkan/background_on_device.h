// The background of a picture, on a device.
#pragma once

#include "draw/prepared_picture.h"
#include "draw/vulkan/environment_on_device.h"
#include "gpu_layout/layout.h"

namespace lambent::draw {

/// Writes the background's part of the record. Returns whether there is a background to draw. `on_device` is the
/// picture's environment, whose panorama is uploaded if it is visible. Throws Error(no_device).
bool describe_background(const vulkan::Device& device, const PreparedPicture& picture,
                         EnvironmentOnDevice& on_device, gpu_layout::PictureRecord& record);

} // namespace lambent::draw
