// Averages the narrow texels near the poles.
#pragma once

#include "environment/panorama/panorama.h"

namespace lambent::environment {

/// Averages texels that are narrower than high, towards the poles, along their rows until they are as wide as high, so
/// that sample points a texel's height apart miss no texel's light.
Panorama with_round_texels(const Panorama& panorama);

} // namespace lambent::environment
