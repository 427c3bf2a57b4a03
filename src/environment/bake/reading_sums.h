// Means over lobes of a panorama interpolated between its texels.
#pragma once

#include "environment/bake/texel_sums.h"

namespace lambent::environment {

/// sum_texels() of a panorama interpolated linearly between its texels (as resized() does, whose code it does not use),
/// by points between them: 1536 or more around a row.
void sum_reading(const Panorama& panorama, std::span<TexelSum> sums);

} // namespace lambent::environment
