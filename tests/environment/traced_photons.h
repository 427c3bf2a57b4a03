// Daylight by following photons down through a flat atmosphere: shares nothing with the sky but the description.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

namespace lambent::environment::testing {

/// One wavelength: vertical optical depths at the ground and what the ground returns.
struct FlatAtmosphere {
    double air, haze, ozone;
    double ground_albedo;
};

class PhotonTracer {
public:
    explicit PhotonTracer(const FlatAtmosphere& atmosphere) : atmosphere_(atmosphere) {}

    /// Of the light on a level surface above the atmosphere, the share that reaches one at 0.3 km after scattering.
    double diffuse_share(double sun_elevation, int photons)
    {
        arrived_ = 0.0;
        const double sine = std::sin(sun_elevation);
        for (int i = 0; i < photons; ++i)
            // Ozone lies above nearly all that scatters.
            follow({60.0, {std::cos(sun_elevation), 0.0, -sine}, std::exp(-atmosphere_.ozone / sine)});
        return arrived_ / photons;
    }

private:
    static constexpr double air_height = 8.0, haze_height = 1.2, surface = 0.3;

    struct Direction {
        double x, y, z; // z is up
    };

    struct Photon {
        double height;
        Direction towards;
        double weight;
        bool scattered = false;
    };

    double random() { return uniform_(engine_); }

    // Height of the next event in one exponential layer of a vertical depth; beyond all if there is none.
    double next_height(const Photon& p, double depth, double scale_height)
    {
        const double left =
            std::exp(-p.height / scale_height) + p.towards.z * std::log(1.0 - random()) / depth;
        return left > 0.0 ? -scale_height * std::log(left) : 1e9;
    }

    void follow(Photon p)
    {
        while (p.weight > 1e-3) {
            const double air = next_height(p, atmosphere_.air, air_height);
            const double haze = next_height(p, atmosphere_.haze, haze_height);
            const bool down = p.towards.z < 0.0, is_haze = down ? haze > air : haze < air;
            const double next = std::max(0.0, is_haze ? haze : air);
            if (down && p.scattered && p.height > surface && next <= surface)
                arrived_ += p.weight;
            if (next > 1e8)
                return;
            p.height = next;
            p.scattered = true;
            if (next <= 0.0) {
                p.weight *= atmosphere_.ground_albedo;
                p.towards = turned({0.0, 0.0, 1.0}, std::sqrt(random()));
            } else if (is_haze) {
                p.weight *= 0.925;
                p.towards = turned(p.towards, haze_cosine());
            } else {
                p.towards = turned(p.towards, air_cosine());
            }
        }
    }

    // Of 3/8 (1 + c^2), by rejection.
    double air_cosine()
    {
        for (;;) {
            const double cosine = 2.0 * random() - 1.0;
            if (2.0 * random() < 1.0 + cosine * cosine)
                return cosine;
        }
    }

    // Of two lobes of Henyey and Greenstein, by inversion.
    double haze_cosine()
    {
        const double g = random() < 0.5 ? 0.5 : 0.9;
        const double t = (1.0 - g * g) / (1.0 - g + 2.0 * g * random());
        return (1.0 + g * g - t * t) / (2.0 * g);
    }

    // A direction at an angle, given by its cosine, from another; to any side.
    Direction turned(const Direction& d, double cosine)
    {
        const double phi = 2.0 * std::numbers::pi * random(), sine = std::sqrt(1.0 - cosine * cosine);
        const double a = sine * std::cos(phi), b = sine * std::sin(phi), level = std::hypot(d.x, d.y);
        if (level < 1e-6)
            return {a, b, d.z > 0.0 ? cosine : -cosine};
        return {cosine * d.x + (a * d.x * d.z - b * d.y) / level,
                cosine * d.y + (a * d.y * d.z + b * d.x) / level, cosine * d.z - a * level};
    }

    FlatAtmosphere atmosphere_;
    double arrived_ = 0.0;
    std::mt19937 engine_{5};
    std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

} // namespace lambent::environment::testing
