// The built-in environment "studio".
#pragma once

#include "image/image.h"

namespace lambent::environment {

/// A dark room with softboxes, `width` texels wide and half as high: key light warm and large at the upper left, behind
/// the default camera, strip light and fill on the right, bank overhead, rim light behind the object.
image::RadianceImage make_studio(int width);

} // namespace lambent::environment
