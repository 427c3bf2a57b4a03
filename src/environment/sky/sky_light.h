// The light of a clear sky, and of the ground under it, from any direction.
#pragma once

#include "environment/sky/atmosphere.h"
#include "environment/sky/multiple_scattering.h"

namespace lambent::environment {

/// Light of one direction, in parts that change slowly over the sky: its radiance in nits is
/// air * air_phase(c) + haze * haze_phase(c, ring) + even, where c is the cosine of the angle to the sun and ring is
/// ClearSky::ring of the elevation.
struct SkyLight {
    Rgb air, haze, even;
};

/// Phase functions of air and haze, per steradian: their integral over the sphere is 1.
/// [air: Rayleigh 1871; haze: two lobes of Henyey and Greenstein 1941] `ring` is the strength of the sharp lobe.
double air_phase(double cosine);
double haze_phase(double cosine, double ring = 1.0);

/// A clear sky as seen from a hill.
class ClearSky {
public:
    /// Elevation of the sun in radians, -0.1 to pi/2; turbidity 1.5 to 10 as Atmosphere.
    ClearSky(double sun_elevation, double turbidity);

    /// Light from an elevation in radians, at a horizontal angle from the sun; without the sun itself.
    SkyLight light(double elevation, double from_sun) const;

    /// Strength, in [0, 1], of the bright ring around the sun at an elevation. Single scattering is computed without
    /// the loss by further small deflections, which makes the ring too bright where haze is deep: at an optical depth
    /// of x the result is x in place of 1 - exp(-x).
    double ring(double elevation) const;

    /// Illuminance in lux of a surface that faces the sun, of the whole disc even when part of it has set.
    Rgb sun_illuminance() const;

    /// Elevation, in radians, of the edge between ground and sky: a little below the horizontal.
    double ground_edge() const;

private:
    struct Scattered;
    Scattered scattered(const Ray& ray, double between_cosine, double length) const;
    Spectrum sky_irradiance() const;

    Atmosphere atmosphere_;
    MultipleScattering multiple_;
    Ray towards_sun_;
    Spectrum ground_; ///< radiance of the ground
};

} // namespace lambent::environment
