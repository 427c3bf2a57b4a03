// The split-sum table of a bake.
#pragma once

#include "image/image.h"

namespace lambent::environment {

/// The split-sum table, size x size (2 to 1024): column x is N.V = (x + 1/2) / size, row y perceptual roughness
/// (y + 1/2) / size. R and G are what F0 and 1 are multiplied by: albedo = F0 R + G. B is R + G, the albedo of a white
/// metal: energy scattered more than once is restored by a factor 1 + F0 (1 / B - 1). [Turquin 2019]
image::RadianceImage bake_split_sum_table(int size);

} // namespace lambent::environment
