// A cube map in memory: six square faces a level, each level half the size of the one before.
#pragma once

#include "image/image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <vector>

namespace lambent::image {

/// Light on the faces of a cube: linear RGB as in RadianceImage, level by level, in a level the faces
/// +X -X +Y -Y +Z -Z, in a face rows from the top and texels from the left.
///
/// Texel (x, y) of a face lies in the direction (+Y is up), with s = (2x + 1) / size - 1 to the right and
/// t = (2y + 1) / size - 1 down:
///     +X ( 1, -t, -s)    +Y (s,  1,  t)    +Z ( s, -t,  1)
///     -X (-1, -t,  s)    -Y (s, -1, -t)    -Z (-s, -t, -1)
/// These are the faces of equations/sphere_maps.glsl and of OpenGL, Vulkan, Direct3D and KTX: a shader that
/// looks a direction up finds the light from there. Whoever stands in the cube of a right-handed world sees
/// the faces as in a mirror, because those interfaces take it for left-handed: see mirrored().
struct CubeMap {
    int size = 0;              ///< of a face at level 0, in texels; any, not only powers of two
    int levels = 0;            ///< 1 to full_levels(size)
    std::vector<float> values; ///< three for each texel

    int face_size(int level) const { return std::max(1, size >> level); }

    /// Floats of one face of a level.
    std::size_t face_floats(int level) const
    {
        const auto n = static_cast<std::size_t>(face_size(level));
        return 3 * n * n;
    }

    /// Index of the first float of a level; that of `levels` is how many there are.
    std::size_t level_start(int level) const
    {
        std::size_t start = 0;
        for (int l = 0; l < level; ++l)
            start += 6 * face_floats(l);
        return start;
    }

    std::span<float> face(int level, int face)
    {
        return std::span(values).subspan(face_start(level, face), face_floats(level));
    }
    std::span<const float> face(int level, int face) const
    {
        return std::span(values).subspan(face_start(level, face), face_floats(level));
    }

    /// The three floats of a texel.
    float* pixel(int level, int face, int x, int y)
    {
        return values.data() + face_start(level, face) + texel(level, x, y);
    }
    const float* pixel(int level, int face, int x, int y) const
    {
        return values.data() + face_start(level, face) + texel(level, x, y);
    }

private:
    std::size_t face_start(int level, int face) const
    {
        return level_start(level) + static_cast<std::size_t>(face) * face_floats(level);
    }
    std::size_t texel(int level, int x, int y) const
    {
        return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(face_size(level)) +
                    static_cast<std::size_t>(x));
    }
};

/// Levels down to a face of one texel.
constexpr int full_levels(int size)
{
    return static_cast<int>(std::bit_width(static_cast<unsigned>(size)));
}

/// A black cube map. Throws Error(usage) as check_cube_map, and std::bad_alloc.
CubeMap make_cube_map(int size, int levels);

/// Throws Error(usage) unless the size is 1 to 65536, the levels 1 to full_levels and the values as many as
/// both say.
void check_cube_map(const CubeMap& map);

/// The same light with x turned round: what viewers want that take cube maps for left-handed and their world
/// for right-handed, and so look up (-x, y, z), as three.js does. Twice is the map itself.
CubeMap mirrored(const CubeMap& map);

/// Names of the faces for files: px nx py ny pz nz.
inline constexpr std::array<const char*, 6> face_names = {"px", "nx", "py", "ny", "pz", "nz"};

/// A face of a level as a picture.
RadianceImage face_image(const CubeMap& map, int level, int face);

/// A level unfolded, four faces wide and three high, black where there is no face:
///        +Y
///     -X +Z +X -Z
///        -Y
RadianceImage cross_image(const CubeMap& map, int level);

} // namespace lambent::image
