// Procedural images of wood, stone and cloth. sRGB codes, RGBA, repeating.
#pragma once

#include "image/image.h"

namespace lambent::kitchen {

/// Plain-sawn boards with the grain along v.
image::CodeImage wood_texture();

/// White marble with grey veins.
image::CodeImage marble_texture();

/// A woven rug with a border, which fills the unit square.
image::CodeImage rug_texture();

} // namespace lambent::kitchen
