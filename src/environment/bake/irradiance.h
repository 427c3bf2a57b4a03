// Light that arrives on a surface from all of its hemisphere.
#pragma once

#include "environment/chain/cube_chain.h"
#include "environment/panorama/panorama.h"

#include <array>

namespace lambent::environment {

/// Irradiance, the integral of radiance times the cosine (lux for radiance in nits), by direction of the surface
/// normal: a one-level CubeChain. A Lambertian surface of albedo a reflects a / pi of it.
using IrradianceMap = CubeChain;

/// Nine coefficients of radiance per channel, [channel][harmonic] in the order of equations/spherical_harmonics.glsl;
/// irradiance by harmonic_irradiance().
using HarmonicLight = std::array<std::array<double, 9>, 3>;

/// Sums over all texels, gathered into cells that keep their light times direction: a cell on one side of the normal's
/// horizon is exact, one across it has an error of the square of its size. Faces have `face_size` (a power of two)
/// texels a side.
IrradianceMap make_irradiance_map(const Panorama& panorama, int face_size = 32);

/// Sums over all texels, in double; panoramas below 256x128 are first enlarged to that.
HarmonicLight project_to_harmonics(const Panorama& panorama);

} // namespace lambent::environment
