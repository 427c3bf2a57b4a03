// An environment as a chain of Gaussian blurs on the faces of a cube: the memory layout, without the lookups.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::environment {

/// Six square faces per level, each with a border of one texel that repeats its neighbours, as half-float RGB.
/// Level l has faces of n = face_size >> l texels and starts at texel 2 n^2 + 24 n + 24 log2(n) - 26: the levels lie
/// coarse to fine without gaps. Faces +X -X +Y -Y +Z -Z as in equations/sphere_maps.glsl.
struct CubeChain {
    int log2_size = 0;  ///< of a face at level 0
    int levels = 0;     ///< the coarsest has faces of 1 << (log2_size - levels + 1) texels
    float scale = 1.0f; ///< radiance = half * scale; a power of two that keeps suns below 65504
    std::vector<std::uint16_t>
        halfs; ///< 3 per texel, and a few more so that a pair of texels may be read as 8

    int face_size(int level) const { return 1 << (log2_size - level); }

    /// Index of texel (0, 0) of a face at a level; (x, y) from -1 to face_size inclusive is at + y * pitch + x.
    std::size_t texel(int level, int face, int x, int y) const
    {
        const std::size_t pitch = static_cast<std::size_t>(face_size(level)) + 2;
        const std::size_t row = static_cast<std::size_t>(face) * pitch + static_cast<std::size_t>(y + 1);
        return level_start(log2_size - level) + row * pitch + static_cast<std::size_t>(x + 1);
    }

    /// First texel of the level whose faces have 2^log2_n texels a side.
    static std::size_t level_start(int log2_n)
    {
        const std::size_t n = std::size_t{1} << log2_n;
        return 2 * n * n + 24 * n + 24 * static_cast<std::size_t>(log2_n) - 26;
    }

    /// Makes room for `levels` levels, all texels 0.
    void allocate(int log2_face_size, int level_count);
};

/// Angular standard deviation of the blur of level 1, in radians; level l has 2^(l-1) times that, level 0 a quarter.
float level_one_deviation(const CubeChain& chain);

} // namespace lambent::environment
