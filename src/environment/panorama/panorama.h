// An image of light from all directions, from a file or a generator.
#pragma once

#include "base/error.h"
#include "environment/panorama/packed_texel.h"
#include "image/image.h"
#include "image/files/image_io.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace lambent::environment {

/// Equirectangular: rows from the zenith (+Y) down, the middle column is +X, +Z a quarter to its right.
/// Four bytes per texel: the background is drawn from it, everything else is computed from it once.
struct Panorama {
    int width = 0;
    int height = 0;
    float scale = 1.0f; ///< radiance = unpack_rgb9e5(texel) * scale; a power of two
    std::vector<std::uint32_t> texels;

    Rgb radiance(int x, int y) const
    {
        const Rgb c = unpack_rgb9e5(texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                           static_cast<std::size_t>(x)]);
        return {c.r * scale, c.g * scale, c.b * scale};
    }
};

/// Solid angle of each texel of row y, in steradians: see image/panorama_rows.h.
double texel_solid_angle(const Panorama& panorama, int y);

/// Reads row by row. Texels that are not finite or above 1e10 get the mean of their neighbours, negative values become
/// 0; warnings count both, and another warns of an aspect other than 2:1. Throws Error(bad_input) as the reader does,
/// and for fewer than 2x1 texels.
Panorama load_panorama(const std::filesystem::path& path, Warnings& warnings);
Panorama load_panorama(image::RadianceReader& reader, const std::string& name, Warnings& warnings);

/// The same as RGB floats, without the rounding of packed texels.
image::RadianceImage load_unpacked_panorama(const std::filesystem::path& path, Warnings& warnings);

/// Packs an image in memory, RGB or RGBA, all values finite and not negative.
Panorama make_panorama(const image::RadianceImage& image);

/// Half as wide and high: each texel the mean over its solid angle, so that the light of every 2x2 block is kept.
/// Width and height must be even.
Panorama halved(const Panorama& panorama);

} // namespace lambent::environment
