// Air, haze and ozone around a round earth: how much light gets through. Lengths in km.
#pragma once

#include "environment/sky/sky_spectrum.h"

#include <vector>

namespace lambent::environment {

/// The start and direction of a ray: altitude above the ground, and the cosine of the angle from the vertical there.
struct Ray {
    double altitude;
    double cosine;
};

/// Densities relative to those at the ground (ozone: to the densest), or their integrals along a path in km.
struct Densities {
    double air = 0.0, haze = 0.0, ozone = 0.0;
};

/// A clear atmosphere. Air and haze thin out exponentially, ozone is a layer.
/// Turbidity is the ratio of the vertical optical depths of air and haze together to that of air, at 550 nm.
///
/// Haze scatters much of its light by angles so small that they matter only close to the sun. For light scattered more
/// than once that share counts as not scattered; light lost otherwise, absorbed or scattered, is called deflected.
/// [delta scaling: Joseph, Wiscombe and Weinman 1976, "The delta-Eddington approximation for radiative flux transfer"]
class Atmosphere {
public:
    static constexpr double ground_radius = 6371.0; ///< mean radius of the earth
    static constexpr double height = 80.0; ///< top of the atmosphere; air there has 1/22000 of its density
    static constexpr double haze_mean_cosine = 0.70; ///< of the angle by which haze scatters

    explicit Atmosphere(double turbidity);

    Densities densities(double altitude) const;

    /// Coefficients per km, for given densities.
    Spectrum air_scattering(const Densities& d) const { return static_cast<float>(d.air) * air_; }
    Spectrum haze_scattering(const Densities& d) const { return static_cast<float>(d.haze) * haze_; }
    Spectrum haze_deflection(const Densities& d) const;
    Spectrum extinction(const Densities& d) const;
    Spectrum deflection(const Densities& d) const;

    /// Transmittance, in each band, from a ray's start, at an altitude from 0 to `height`, to space, by integration.
    /// The ray must not meet the ground.
    Spectrum transmittance(const Ray& ray) const;

    /// The share of light that is not deflected on that path; from a table.
    Spectrum undeflected(const Ray& ray) const;

    /// Optical depth, at 560 nm, of the scattering by haze that counts as not deflecting, on that path.
    double forward_depth(const Ray& ray) const;

private:
    Densities columns(const Ray& ray) const;
    void fill_table();

    Spectrum air_, haze_, haze_extinction_, ozone_absorption_;
    std::vector<Spectrum> table_;
};

/// Transmittance of an optical depth: exp(-depth), band by band.
Spectrum transmitted(const Spectrum& depth);

/// Cosine of the angle from the vertical at which the ground's edge is seen.
double horizon_cosine(double altitude);

/// Distance along a ray to the top of the atmosphere.
double distance_to_space(const Ray& ray);

/// Distance to the ground along a ray that goes below the horizon.
double distance_to_ground(const Ray& ray);

/// The same ray from the point at a distance along it.
Ray further_along(const Ray& ray, double distance);

/// Share of the sun's disc, of angular radius `sun_radius`, above the ground's edge.
double visible_sun(const Ray& towards_sun);

inline constexpr double sun_radius = 0.265 * 3.14159265358979 / 180.0; ///< radians, as seen from the earth

} // namespace lambent::environment
