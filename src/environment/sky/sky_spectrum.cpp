#include "environment/sky/sky_spectrum.h"

#include <cmath>

namespace lambent::environment {
namespace {

// W m^-2 nm^-1, means over 10 nm, the first over 380 to 390 nm. [ASTM G173-03, extraterrestrial column]
constexpr double sunlight[] = {1.01249, 1.14716, 1.72765, 1.73054, 1.6887,  1.61253, 1.91198, 2.03474,
                               2.02042, 2.02212, 1.93377, 1.95809, 1.91686, 1.8298,  1.8685,  1.8931,
                               1.85149, 1.8504,  1.8341,  1.8345,  1.8147,  1.78158, 1.7533,  1.6965,
                               1.68194, 1.64654, 1.6048,  1.52143, 1.55622, 1.5113,  1.474,   1.4482,
                               1.41018, 1.36775, 1.34188, 1.31429};
constexpr double sunlight_start = 380.0;
constexpr double sunlight_step = 10.0;
constexpr double lumens_per_watt = 683.0;

// A Gaussian with a width for each side, given as inverse standard deviations. [Wyman et al. 2013, eq. 4]
double lobe(double wavelength, double centre, double below, double above)
{
    const double t = (wavelength - centre) * (wavelength < centre ? below : above);
    return std::exp(-0.5 * t * t);
}

struct Xyz {
    double x, y, z;
};

Xyz colour_matching(double nm)
{
    return {0.362 * lobe(nm, 442.0, 0.0624, 0.0374) + 1.056 * lobe(nm, 599.8, 0.0264, 0.0323) -
                0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
            0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
            1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
}

// Daylight film sees CIE illuminant D55 as white, the display's white is D65. Scaling X and Z keeps luminance exact.
// [ISO 7589; CIE 15, table T.3]
constexpr double d55_x = 0.95682, d55_z = 0.92149;
constexpr double d65_x = 0.95047, d65_z = 1.08883;

Rgb rec709(Xyz c)
{
    c = {c.x * d65_x / d55_x, c.y, c.z * d65_z / d55_z};
    return {static_cast<float>(3.2406 * c.x - 1.5372 * c.y - 0.4986 * c.z),
            static_cast<float>(-0.9689 * c.x + 1.8758 * c.y + 0.0415 * c.z),
            static_cast<float>(0.0557 * c.x - 0.2040 * c.y + 1.0570 * c.z)};
}

// A wavelength between two bands: `share` of it belongs to band `first`, the rest to the next.
struct BandBlend {
    int first;
    double share;
};

BandBlend bands_at(double nm)
{
    int first = 0;
    while (first < band_count - 2 && nm > band_wavelengths[static_cast<std::size_t>(first) + 1])
        ++first;
    const auto fourth = [](double v) { return 1.0 / (v * v * v * v); };
    const double left = fourth(band_wavelengths[static_cast<std::size_t>(first)]);
    const double right = fourth(band_wavelengths[static_cast<std::size_t>(first) + 1]);
    const double share = (fourth(nm) - right) / (left - right);
    return {first, share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share};
}

// RGB of all sunlight that belongs to each band.
std::array<Rgb, band_count> make_weights()
{
    std::array<Xyz, band_count> sums{};
    double nm = sunlight_start + 0.5 * sunlight_step;
    for (const double watts : sunlight) {
        const BandBlend p = bands_at(nm);
        const Xyz eye = colour_matching(nm);
        const double lumens = lumens_per_watt * sunlight_step * watts;
        for (const int side : {0, 1}) {
            Xyz& sum = sums[static_cast<std::size_t>(p.first + side)];
            const double weight = lumens * (side == 0 ? p.share : 1.0 - p.share);
            sum = {sum.x + weight * eye.x, sum.y + weight * eye.y, sum.z + weight * eye.z};
        }
        nm += sunlight_step;
    }
    std::array<Rgb, band_count> weights;
    for (std::size_t i = 0; i < weights.size(); ++i)
        weights[i] = rec709(sums[i]);
    return weights;
}

} // namespace

Rgb sunlight_rgb(const Spectrum& share)
{
    static const std::array<Rgb, band_count> weights = make_weights();
    Rgb sum;
    for (int i = 0; i < band_count; ++i) {
        const Rgb& weight = weights[static_cast<std::size_t>(i)];
        sum = {sum.r + share[i] * weight.r, sum.g + share[i] * weight.g, sum.b + share[i] * weight.b};
    }
    return sum;
}

} // namespace lambent::environment
