// Procedural textures of strong colours, which show how colours are reproduced. sRGB codes, RGBA.
#pragma once

#include "image/image.h"

namespace lambent::scene {

/// A colour chart for a sphere: hue varies around it, and from pole to pole colours go from pale over saturated to
/// dark. Light joints separate the cells.
image::CodeImage color_chart();

/// Two by two tiles of two muted colours, to be repeated.
image::CodeImage floor_tiles();

} // namespace lambent::scene
