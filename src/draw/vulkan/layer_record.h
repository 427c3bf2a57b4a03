// A picture's layers in the record for shaders: the column of each, and how it is read.
#pragma once

#include "draw/layer_list.h"
#include "gpu_layout/layout.h"

#include <span>

namespace lambent::draw {

/// Appends these layers and then that of the background to the record, and counts them in samples.z, which must be 0
/// before. Throws Error(no_device), before it writes anything, if the layers exceed gpu_layout::most_layers.
void list_layers(std::span<const LayerSource> sources, gpu_layout::PictureRecord& record);

/// Appends the layer of unlit surfaces. Throws Error(no_device) if the record is full.
void list_unlit(gpu_layout::PictureRecord& record);

} // namespace lambent::draw
