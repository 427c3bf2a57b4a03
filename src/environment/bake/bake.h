// Environments prefiltered for renderers that look them up once: irradiance, specular light by roughness, and the
// split-sum table. [Karis 2013, "Real shading in Unreal Engine 4"]
#pragma once

#include "environment/bake/irradiance.h"
#include "environment/panorama/panorama.h"
#include "environment/bake/prefilter_faces.h"
#include "image/cube/cube_map.h"

#include <functional>
#include <vector>

namespace lambent::environment {

/// The lobe over which a level of the specular cube averages, about the mirrored direction R = N = V.
enum class BakeLobe {
    ggx,   ///< D(h) N.L over its integral, h half way between N and L
    phong, ///< the report's lobe, (R.L)^n over its integral, n = phong_exponent(alpha)
};

/// Perceptual roughness of level l of n, t = l / (n - 1).
enum class RoughnessMapping {
    linear, ///< t: texel and lobe sizes grow together over the middle of the range
    cmgen,  ///< 1 - sqrt(1 - t), as Filament's cmgen
};

struct BakeOptions {
    int size = 256; ///< of a face at level 0, a power of two from 1 to 4096; levels go down to one texel
    BakeLobe lobe = BakeLobe::ggx;
    RoughnessMapping mapping = RoughnessMapping::linear;
    double error = 0.01; ///< relative RMSE aimed at, 0.0005 to 0.2
};

struct BakedLevel {
    double perceptual_roughness = 0.0;
    /// Relative RMSE measured at random texels, against the sum over all of the panorama's texels in double; for a
    /// panorama below 1024x512 against the sum over the panorama interpolated linearly between its texels.
    double error = 0.0;
};

struct BakedSpecular {
    image::CubeMap cube; ///< radiance
    std::vector<BakedLevel> levels;
};

/// Throws Error(usage) for options out of range, and what `fill` throws. `report` is called with the share done, by one
/// thread at a time. Levels that `fill` computes on another device are still checked on the CPU.
BakedSpecular bake_specular(const Panorama& panorama, const BakeOptions& options,
                            const std::function<void(double)>& report = {},
                            const FillFaces& fill = prefilter_faces);

/// Irradiance by direction of the normal (lux for radiance in nits), one level, faces of `size` texels (1 to 4096).
image::CubeMap bake_irradiance(const Panorama& panorama, int size, const FillFaces& fill = prefilter_faces);

/// Nine coefficients of irradiance, RGB by RGB: irradiance(n) = sum of c_i Y_i(n), Y in the order of
/// equations/spherical_harmonics.glsl. From radiance by the clamped cosine. [Ramamoorthi and Hanrahan 2001]
std::vector<double> irradiance_coefficients(const HarmonicLight& light);

} // namespace lambent::environment
