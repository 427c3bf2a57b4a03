#include "image/cube/cube_panorama.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lambent::image {
namespace {

using Direction = std::array<double, 3>;

// On a face, from the upper left corner of the first texel, in texels.
struct FacePlace {
    int face;
    double x, y;
};

Direction direction_of(int face, double x, double y, int size)
{
    const double s = 2.0 * x / size - 1.0, t = 2.0 * y / size - 1.0;
    const std::array<Direction, 6> all = {
        {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}}};
    return all[static_cast<std::size_t>(face)];
}

FacePlace place_of(const Direction& d, int size)
{
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::fabs(d[i]) > std::fabs(d[axis]))
            axis = i;
    const double over = 1.0 / std::fabs(d[axis]);
    const bool negative = d[axis] < 0.0;
    const double sign = negative ? -1.0 : 1.0;
    double s = over * d[0], t = -over * d[1];
    if (axis == 0)
        s = -sign * over * d[2];
    if (axis == 1)
        t = sign * over * d[2];
    if (axis == 2)
        s *= sign;
    return {static_cast<int>(2 * axis) + (negative ? 1 : 0), 0.5 * (s + 1.0) * size, 0.5 * (t + 1.0) * size};
}

// A level of a cube map, to be looked up.
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

// Calls visit(x, y, weight) for the four texels around a point.
template <class Visit>
void around(const FacePlace& at, const Visit& visit)
{
    const double x = std::floor(at.x - 0.5), y = std::floor(at.y - 0.5);
    const double u = at.x - 0.5 - x, v = at.y - 0.5 - y;
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    visit(left, top, (1.0 - u) * (1.0 - v));
    visit(left + 1, top, u * (1.0 - v));
    visit(left, top + 1, (1.0 - u) * v);
    visit(left + 1, top + 1, u * v);
}

// Bilinear. Beyond an edge the face's plane goes on, and what would be its texel there is looked up, bilinearly
// too, among those of the neighbouring face.
void look_up(const Level& level, const FacePlace& at, float* rgb)
{
    around(at, [&](int x, int y, double weight) {
        if (level.has(x, y))
            return level.add_texel(at.face, x, y, weight, rgb);
        const FacePlace there = place_of(direction_of(at.face, x + 0.5, y + 0.5, level.size), level.size);
        around(there,
               [&](int i, int j, double share) { level.add_texel(there.face, i, j, weight * share, rgb); });
    });
}

} // namespace

RadianceImage equirectangular_image(const CubeMap& map, int level, int height)
{
    check_cube_map(map);
    if (height < 1 || height > 32768)
        throw Error(Failure::usage, text("a panorama ", height, " texels high: 1 to 32768 are possible"));
    if (level < 0 || level >= map.levels)
        throw Error(Failure::usage, text("level ", level, " of a cube map that has ", map.levels));
    const int width = 2 * height, size = map.face_size(level);
    RadianceImage image{width, height, 3, {}};
    image.values.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const double theta = (y + 0.5) / height * std::numbers::pi;
        for (int x = 0; x < width; ++x) {
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
            const Direction d = {std::sin(theta) * std::cos(phi), std::cos(theta),
                                 std::sin(theta) * std::sin(phi)};
            look_up({map, level, size}, place_of(d, size), image.pixel(x, y));
        }
    }
    return image;
}

} // namespace lambent::image
