// Textures with strong colours, made by code: what shows how colours fare. sRGB codes, RGBA.
#pragma once

#include "image/image.h"

namespace lambent::scene {

/// A chart for a sphere: hues around, from pale over strong to dark from pole to pole, with light joints between.
image::CodeImage color_chart();

/// Two by two tiles of two muted colours, to be repeated.
image::CodeImage floor_tiles();

} // namespace lambent::scene
