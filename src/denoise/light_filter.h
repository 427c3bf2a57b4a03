// A filter for noisy Monte Carlo light whose unshadowed part is known exactly; docs/FILTER.md says how it works.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace lambent::denoise {

/// One value per pixel, row by row from the top.
using Plane = std::vector<float>;
/// Three planes of linear light or albedo.
using Rgb = std::array<Plane, 3>;

/// What a pixel shows. Where coverage is 0 the other planes are not looked at.
struct Guides {
    Plane coverage; ///< share of the pixel that surfaces cover, in [0, 1]; 0: not filtered, result 0
    std::array<Plane, 3> normal; ///< mean over the pixel, of length 1
    Plane depth;                 ///< metres along the ray, above 0
    Plane alpha;                 ///< width of the specular lobe, perceptual roughness squared, in [0, 1]
    Plane metalness;             ///< in [0, 1]; any number that tells materials apart does
};

/// Means over half of a pixel's samples, independent of the other half.
struct Half {
    Rgb unshadowed; ///< a noisy estimate of Light::exact, at least 0
    Rgb found; ///< the true light by the same samples: shadowed, with what other surfaces send; at least 0
};

/// One class of light, diffuse or specular, per covered area: mean over the covered part of the pixel.
struct Light {
    Rgb exact; ///< light with nothing in its way, without noise, at least 0
    /// What the light is proportional to, at least 0; where it is 0, so must be the light. Its texture is not blurred.
    /// Three empty planes: 1 everywhere.
    Rgb albedo;
    std::array<Half, 2> halves;
};

struct Picture {
    int width = 0, height = 0;
    Guides guides;
    Plane count; ///< samples of both halves at each pixel, at least 2, as many in one half as in the other
    Light diffuse, specular;
};

struct Settings {
    /// Radiance that is shown as white, above 0: where exact light is above it, errors count less by their quotient.
    float cut = 1.0f;
    /// Most that true light may be times unshadowed light where it is found as a ratio, at least 1; what is above is kept as
    /// an amount.
    float ratio_limit = 2.0f;
};

struct FilteredLight {
    Rgb light; ///< filtered true light, at least 0; 0 where coverage is 0
    Rgb gap; ///< the first half's filtered light minus the second's: of the size of twice the result's noise
};

struct Filtered {
    FilteredLight diffuse, specular;
};

/// A part of a row of one class's result. The planes are as of FilteredLight.
struct FilteredRow {
    int x = 0, y = 0, columns = 0;
    bool specular = false;
    std::array<const float*, 3> light{}, gap{};
};
using TakeRow = std::function<void(const FilteredRow&)>;

/// Filters both classes. Finite input gives finite output, the same bytes with any number of threads, though not with
/// other instruction sets. Throws Error(usage) for planes that are not of width x height pixels.
/// Needs about 12 MB for each thread besides its result.
Filtered filter_light(const Picture& picture, const Settings& settings);

/// The same, with each part of a row handed over once. Several threads call `take`, but not for the same pixels at once.
void filter_light(const Picture& picture, const Settings& settings, const TakeRow& take);

} // namespace lambent::denoise
