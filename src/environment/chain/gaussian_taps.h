// Sample directions of a Gaussian blur on the sphere.
#pragma once

#include <vector>

namespace lambent::environment {

/// Directions around +z in which a Gaussian on the sphere is sampled, all of equal weight.
struct GaussianTaps {
    static constexpr int around = 8; ///< taps per ring
    std::vector<float> x, y, z;
};

/// Taps of standard deviation `deviation` radians on 4 or 5 rings, each turned by half a step against the one before.
/// Their mean is +z and their moments up to the seventh are isotropic, so that a blur moves no light and looks the same
/// in the frames of neighbouring faces.
GaussianTaps gaussian_taps(int rings, float deviation);

} // namespace lambent::environment
