// Pictures of wood, stone and cloth, made by code. sRGB codes, RGBA, repeating.
#pragma once

#include "image/image.h"

namespace lambent::kitchen {

/// Plain-sawn boards: grain along v.
image::CodeImage wood_texture();

/// White marble with grey veins.
image::CodeImage marble_texture();

/// A woven rug with a border, once over the unit square.
image::CodeImage rug_texture();

} // namespace lambent::kitchen
