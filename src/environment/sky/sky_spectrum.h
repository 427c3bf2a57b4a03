// Sunlight in a few spectral bands, and its colour.
#pragma once

#include "environment/panorama/packed_texel.h"

#include <array>

namespace lambent::environment {

constexpr int band_count = 8;

/// Centres of the bands, nm. Spectra are interpolated linearly in wavelength^-4, to which scattering by air is
/// proportional.
constexpr std::array<double, band_count> band_wavelengths = {400.0, 440.0, 480.0, 520.0,
                                                             560.0, 600.0, 640.0, 680.0};

/// One number per band. As light, it is a share of the sunlight outside the atmosphere: of its irradiance, or of that
/// per steradian.
struct Spectrum {
    std::array<float, band_count> band{};

    float& operator[](int i) { return band[static_cast<std::size_t>(i)]; }
    float operator[](int i) const { return band[static_cast<std::size_t>(i)]; }

    static Spectrum all(float value)
    {
        Spectrum s;
        s.band.fill(value);
        return s;
    }

    Spectrum& operator+=(const Spectrum& b)
    {
        for (int i = 0; i < band_count; ++i)
            (*this)[i] += b[i];
        return *this;
    }

    Spectrum& operator*=(const Spectrum& b)
    {
        for (int i = 0; i < band_count; ++i)
            (*this)[i] *= b[i];
        return *this;
    }

    Spectrum& operator*=(float f) { return *this *= all(f); }
};

inline Spectrum operator+(Spectrum a, const Spectrum& b)
{
    return a += b;
}

inline Spectrum operator*(Spectrum a, const Spectrum& b)
{
    return a *= b;
}

inline Spectrum operator*(float f, Spectrum a)
{
    return a *= f;
}

/// Converts a share of sunlight to lux (or, per steradian, nits), Rec. 709 red, green and blue. Colours beyond Rec. 709
/// have a negative component.
/// [sunlight: ASTM G173-03, extraterrestrial; eye: Wyman, Sloan and Shirley 2013, "Simple analytic approximations to
/// the CIE XYZ color matching functions"; 683 lm/W; XYZ to RGB: IEC 61966-2-1]
Rgb sunlight_rgb(const Spectrum& share);

} // namespace lambent::environment
