// Cube maps in memory: six square faces per level, each level half the size of the previous one.
#pragma once

#include "image/image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <vector>

namespace lambent::image {

/// Light on the faces of a cube: linear RGB as in RadianceImage, by level, then by face (+X -X +Y -Y +Z -Z), then
/// by row from the top, texels from the left.
///
/// With s = (2x + 1) / size - 1 to the right and t = (2y + 1) / size - 1 down, the direction of texel (x, y) of a
/// face is (+Y is up)
///     +X ( 1, -t, -s)    +Y (s,  1,  t)    +Z ( s, -t,  1)
///     -X (-1, -t,  s)    -Y (s, -1, -t)    -Z (-s, -t, -1)
/// as in equations/sphere_maps.glsl, OpenGL, Vulkan, Direct3D and KTX: a lookup of a direction in a shader returns
/// the light from there. These interfaces define the cube in a left-handed frame, so that a viewer inside it in a
/// right-handed world sees the faces mirrored: see mirrored().
struct CubeMap {
    int size = 0;              ///< width of a face at level 0, in texels; not only powers of two
    int levels = 0;            ///< 1 to full_levels(size)
    std::vector<float> values; ///< three for each texel

    int face_size(int level) const { return std::max(1, size >> level); }

    /// Number of floats of a face of a level.
    std::size_t face_floats(int level) const
    {
        const auto n = static_cast<std::size_t>(face_size(level));
        return 3 * n * n;
    }

    /// Index of the first float of a level. level_start(levels) is the number of floats.
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

/// Number of levels down to faces of one texel.
constexpr int full_levels(int size)
{
    return static_cast<int>(std::bit_width(static_cast<unsigned>(size)));
}

/// A black cube map. Throws Error(usage) as check_cube_map, and std::bad_alloc.
CubeMap make_cube_map(int size, int levels);

/// Throws Error(usage) unless the size is 1 to 65536, the levels are 1 to full_levels(size) and the number of
/// values matches both.
void check_cube_map(const CubeMap& map);

/// The map mirrored in x, for viewers with a right-handed world that look up (-x, y, z) in a left-handed cube map,
/// as three.js does. Mirroring twice gives the original map.
CubeMap mirrored(const CubeMap& map);

/// Names of the faces in file names.
inline constexpr std::array<const char*, 6> face_names = {"px", "nx", "py", "ny", "pz", "nz"};

/// A face of a level as an image.
RadianceImage face_image(const CubeMap& map, int level, int face);

/// A level unfolded to a cross, four faces wide and three high, black between the faces:
///        +Y
///     -X +Z +X -Z
///        -Y
RadianceImage cross_image(const CubeMap& map, int level);

} // namespace lambent::image
