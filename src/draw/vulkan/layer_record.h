// How the shaders know a picture's layers: each as a column of the fragments and how it is read.
#pragma once

#include "draw/layer_list.h"
#include "gpu_layout/layout.h"

#include <span>

namespace lambent::draw {

/// Lists these layers and, last, the background in the record, and counts them in its samples.z, which was 0. Throws
/// Error(no_device), before anything is written, where the record has no room for all of them or the device does not keep
/// what one of them shows.
void list_layers(std::span<const LayerSource> sources, gpu_layout::PictureRecord& record);

/// Lists after them what is shown without lighting. Throws likewise.
void list_unlit(gpu_layout::PictureRecord& record);

} // namespace lambent::draw
