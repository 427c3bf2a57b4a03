// Light that was scattered more than once.
#pragma once

#include "environment/sky/atmosphere.h"

#include <vector>

namespace lambent::environment {

/// Albedo of the ground, which reflects diffusely: pale dry ground.
/// [about that of light concrete and dry soil: Dobos 2003, "Albedo", Encyclopedia of Soil Science]
const Spectrum& ground_albedo();

/// Light of all scattering orders from the second on, taken as arriving and scattered isotropically.
/// [Hillaire 2020, "A scalable and production ready sky and atmosphere rendering technique", sec. 5.5]
/// Tabulated for one elevation of the sun, as far around the earth as is visible from near the ground.
class MultipleScattering {
public:
    /// `sun_elevation` in radians above the horizontal, as seen from the ground.
    MultipleScattering(const Atmosphere& atmosphere, double sun_elevation);

    /// Mean radiance arriving at an altitude where the sun is at the given cosine from the vertical, as a share of the
    /// sun's irradiance per steradian.
    Spectrum arriving(const Ray& towards_sun) const;

private:
    double first_angle_;
    std::vector<Spectrum> table_;
};

} // namespace lambent::environment
