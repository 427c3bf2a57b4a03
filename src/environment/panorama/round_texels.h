// Texels as wide as high.
#pragma once

#include "environment/panorama/panorama.h"

namespace lambent::environment {

/// Texels that are narrower than high, towards the poles, averaged along their rows until they are not: so that points of a
/// texel's height apart meet each, with its light.
Panorama with_round_texels(const Panorama& panorama);

} // namespace lambent::environment
