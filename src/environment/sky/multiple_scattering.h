// Light that was scattered more than once.
#pragma once

#include "environment/sky/atmosphere.h"

#include <vector>

namespace lambent::environment {

/// How much of the light that meets the ground it returns, evenly to all directions: pale dry ground.
/// [about that of light concrete and dry soil: Dobos 2003, "Albedo", Encyclopedia of Soil Science]
const Spectrum& ground_albedo();

/// All orders from the second on, as if all of it came evenly from everywhere and was scattered evenly.
/// [Hillaire 2020, "A scalable and production ready sky and atmosphere rendering technique", sec. 5.5]
/// Known for one height of the sun, and so far around the earth as one can see from near the ground.
class MultipleScattering {
public:
    /// `sun_elevation` in radians above the horizontal, as seen from the ground.
    MultipleScattering(const Atmosphere& atmosphere, double sun_elevation);

    /// Radiance arriving on average at an altitude where the sun is at the given cosine from the vertical, as a share
    /// of the sun's irradiance per steradian.
    Spectrum arriving(const Ray& towards_sun) const;

private:
    double first_angle_;
    std::vector<Spectrum> table_;
};

} // namespace lambent::environment
