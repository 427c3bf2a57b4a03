// The built-in kitchen: a path-traced panorama that is embedded in the program.
#pragma once

#include "image/image.h"

namespace lambent::environment {

/// `width` texels wide, half as high; a power of two from 64. The stored one is 2048x1024; smaller ones are means of
/// its texels by solid angle, larger ones are interpolated. The scene is tools/kitchen/model/.
image::RadianceImage make_kitchen(int width);

} // namespace lambent::environment
