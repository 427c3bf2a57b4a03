// Air, haze and ozone around a round earth: how much light gets through. Lengths in km.
#pragma once

#include "environment/sky/sky_spectrum.h"

#include <vector>

namespace lambent::environment {

/// A place and a way: altitude above the ground and the cosine of the angle from the vertical there.
struct Ray {
    double altitude;
    double cosine;
};

/// Densities relative to those at the ground (ozone: to the densest), or their integrals along a way in km.
struct Densities {
    double air = 0.0, haze = 0.0, ozone = 0.0;
};

/// A clear atmosphere. Air and haze thin out exponentially, ozone is a layer.
/// Turbidity is the ratio of the vertical optical depths of air and haze together to that of air, at 550 nm.
///
/// Haze scatters much light by so little that it matters only close to the sun. Where light is scattered more than once,
/// that share counts as not scattered: what is lost otherwise, by absorption or scattering, is called deflected.
/// [delta scaling: Joseph, Wiscombe and Weinman 1976, "The delta-Eddington approximation for radiative flux transfer"]
class Atmosphere {
public:
    static constexpr double ground_radius = 6371.0; ///< mean radius of the earth
    static constexpr double height = 80.0; ///< of what is left away above, air has 1/22000 of its density
    static constexpr double haze_mean_cosine = 0.70; ///< of the angle by which haze scatters

    explicit Atmosphere(double turbidity);

    Densities densities(double altitude) const;

    /// Per km, for given densities.
    Spectrum air_scattering(const Densities& d) const { return static_cast<float>(d.air) * air_; }
    Spectrum haze_scattering(const Densities& d) const { return static_cast<float>(d.haze) * haze_; }
    Spectrum haze_deflection(const Densities& d) const;
    Spectrum extinction(const Densities& d) const;
    Spectrum deflection(const Densities& d) const;

    /// From a ray's start, at an altitude from 0 to `height`, out to space: the share of light that gets through, in
    /// each band. The ray must not meet the ground. By integration.
    Spectrum transmittance(const Ray& ray) const;

    /// The same, but what gets through without being deflected; from a table.
    Spectrum undeflected(const Ray& ray) const;

    /// Optical depth, at 560 nm, of the scattering by haze that counts as not deflecting, on the same way.
    double forward_depth(const Ray& ray) const;

private:
    Densities columns(const Ray& ray) const;
    void fill_table();

    Spectrum air_, haze_, haze_extinction_, ozone_absorption_;
    std::vector<Spectrum> table_;
};

/// What is left after extinction of `depth`: exp(-depth), band by band.
Spectrum transmitted(const Spectrum& depth);

/// Cosine of the angle from the vertical at which the ground's edge is seen.
double horizon_cosine(double altitude);

/// How far along a ray the top of the atmosphere is.
double distance_to_space(const Ray& ray);

/// How far the ground is, along a ray that goes below the horizon.
double distance_to_ground(const Ray& ray);

/// The ray as it is after a distance.
Ray further_along(const Ray& ray, double distance);

/// Share of the sun's disc, of angular radius `sun_radius`, above the ground's edge.
double visible_sun(const Ray& towards_sun);

inline constexpr double sun_radius = 0.265 * 3.14159265358979 / 180.0; ///< radians, as seen from the earth

} // namespace lambent::environment
