#include "image/cube/cube_panorama.h"

#include "base/error.h"
#include "base/text.h"
#include "equations/in_double.h"

#include <algorithm>
#include <cmath>

namespace lambent::image {
namespace {

using in_double::CubePlace;

// A level of a cube map, for lookups.
struct Level {
    const CubeMap& map;
    int level, size;

    bool has(int x, int y) const { return x >= 0 && y >= 0 && x < size && y < size; }

    void add_texel(int face, int x, int y, double weight, float* rgb) const
    {
        const float* from = map.pixel(level, face, std::clamp(x, 0, size - 1), std::clamp(y, 0, size - 1));
        for (int k = 0; k < 3; ++k)
            rgb[k] += static_cast<float>(weight) * from[k];
    }
};

// Calls visit(x, y, weight) for the four texels around a position on a face `size` texels wide.
template <class Visit>
void around(const CubePlace& at, int size, const Visit& visit)
{
    const double right = 0.5 * (at.s + 1.0) * size - 0.5, down = 0.5 * (at.t + 1.0) * size - 0.5;
    const double x = std::floor(right), y = std::floor(down);
    const double u = right - x, v = down - y;
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    visit(left, top, (1.0 - u) * (1.0 - v));
    visit(left + 1, top, u * (1.0 - v));
    visit(left, top + 1, (1.0 - u) * v);
    visit(left + 1, top + 1, u * v);
}

// Adds a bilinear lookup to `rgb`. A texel beyond an edge, on the continued plane of the face, is itself looked up
// bilinearly on the neighbouring face.
void look_up(const Level& level, const CubePlace& at, float* rgb)
{
    const int face = static_cast<int>(at.face), size = level.size;
    around(at, size, [&](int x, int y, double weight) {
        if (level.has(x, y))
            return level.add_texel(face, x, y, weight, rgb);
        const CubePlace there = in_double::cube_from_direction(
            in_double::direction_from_cube(face, 2.0 * (x + 0.5) / size - 1.0, 2.0 * (y + 0.5) / size - 1.0));
        around(there, size, [&](int i, int j, double share) {
            level.add_texel(static_cast<int>(there.face), i, j, weight * share, rgb);
        });
    });
}

} // namespace

RadianceImage equirectangular_image(const CubeMap& map, int level, int height)
{
    check_cube_map(map);
    if (height < 1 || height > 32768)
        throw Error(Failure::usage, text("a panorama ", height, " texels high: 1 to 32768 are possible"));
    if (level < 0 || level >= map.levels)
        throw Error(Failure::usage, text("level ", level, " of a cube map with ", map.levels, " levels"));
    const int width = 2 * height, size = map.face_size(level);
    RadianceImage image = black_image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const in_double::vec3 d =
                in_double::direction_from_equirectangular({(x + 0.5) / width, (y + 0.5) / height});
            look_up({map, level, size}, in_double::cube_from_direction(d), image.pixel(x, y));
        }
    return image;
}

} // namespace lambent::image
