// The texel formats of image/ in which panoramas and cubes are stored.
#pragma once

#include "image/packed_texel.h"

namespace lambent::environment {

using image::from_half;
using image::pack_rgb9e5;
using image::Rgb;
using image::to_half;
using image::unpack_rgb9e5;

} // namespace lambent::environment
