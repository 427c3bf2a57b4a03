// Means over lobes of a panorama as it is read between its texels.
#pragma once

#include "environment/bake/texel_sums.h"

namespace lambent::environment {

/// sum_texels of a panorama read linearly between its texels (as resized() does, of whose code it uses nothing): by points
/// between them, so many that they are 1536 or more to a turn.
void sum_reading(const Panorama& panorama, std::span<TexelSum> sums);

} // namespace lambent::environment
