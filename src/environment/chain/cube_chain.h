// An environment as a chain of Gaussian blurs on the faces of a cube: the memory layout, without the lookups.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

namespace lambent::environment {

/// Six square faces per level, each with a border of one texel that repeats its neighbours, as half-float RGB. Faces
/// +X -X +Y -Y +Z -Z as in equations/sphere_maps.glsl. A level of faces of n texels starts at texel 8 n^2, found by one
/// shift; the gaps between levels are never touched and so take no memory.
class CubeChain {
public:
    int log2_size = 0;  ///< log2 of a face's texels per side at level 0
    int levels = 0;     ///< the coarsest has faces of 1 << (log2_size - levels + 1) texels
    float scale = 1.0f; ///< radiance = half * scale; a power of two, so that suns stay below 65504

    /// Allocates `level_count` levels, all texels 0. The coarsest must have faces of 2 texels or more, unless it is
    /// the only one. Throws std::bad_alloc.
    void allocate(int log2_face_size, int level_count);

    int face_size(int level) const { return 1 << (log2_size - level); }

    /// Three halfs per texel, and 8 more at the end, so that any pair of texels can be read as eight halfs.
    std::uint16_t* halfs() { return halfs_.get(); }
    const std::uint16_t* halfs() const { return halfs_.get(); }

    /// Index of texel (x, y) of a face at a level, each coordinate from -1 to face_size inclusive.
    std::size_t texel(int level, int face, int x, int y) const
    {
        const std::size_t n = static_cast<std::size_t>(face_size(level)), pitch = n + 2;
        const std::size_t row = static_cast<std::size_t>(face) * pitch + static_cast<std::size_t>(y + 1);
        return 8 * n * n + row * pitch + static_cast<std::size_t>(x + 1);
    }

    /// One past the last texel.
    std::size_t end() const { return texel(0, 5, face_size(0), face_size(0)) + 1; }

private:
    struct Free {
        void operator()(void* p) const { std::free(p); }
    };
    std::unique_ptr<std::uint16_t[], Free> halfs_;
};

/// Angular standard deviation of the blur of level 1, in radians; level l has 2^(l-1) times that, level 0 a quarter.
float level_one_deviation(const CubeChain& chain);

} // namespace lambent::environment
