// Display codes as numbers.
#pragma once

#include "image/image.h"

namespace lambent::compare {

/// RGB codes from 0 to 1; alpha is left out.
image::RadianceImage code_values(const image::CodeImage& codes);

/// The linear light that sRGB codes from 0 to 1 are shown as. [IEC 61966-2-1]
image::RadianceImage light_of_codes(const image::RadianceImage& codes);

} // namespace lambent::compare
