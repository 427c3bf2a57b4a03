#include "image/cube_panorama.h"

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
struct Place {
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

Place place_of(const Direction& d, int size)
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

// The texel, of the neighbouring face if it is beyond an edge.
const float* texel(const CubeMap& map, int level, int face, int x, int y)
{
    const int size = map.face_size(level);
    Place at{face, x + 0.5, y + 0.5};
    if (x < 0 || y < 0 || x >= size || y >= size)
        at = place_of(direction_of(face, at.x, at.y, size), size);
    return map.pixel(level, at.face, std::clamp(static_cast<int>(at.x), 0, size - 1),
                     std::clamp(static_cast<int>(at.y), 0, size - 1));
}

// Bilinear between the four texels around.
void look_up(const CubeMap& map, int level, const Place& at, float* rgb)
{
    const double x = std::floor(at.x - 0.5), y = std::floor(at.y - 0.5);
    const double u = at.x - 0.5 - x, v = at.y - 0.5 - y;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const float* from = texel(map, level, at.face, static_cast<int>(x) + i, static_cast<int>(y) + j);
            const auto weight = static_cast<float>((i == 1 ? u : 1.0 - u) * (j == 1 ? v : 1.0 - v));
            for (int k = 0; k < 3; ++k)
                rgb[k] += weight * from[k];
        }
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
            look_up(map, level, place_of(d, size), image.pixel(x, y));
        }
    }
    return image;
}

} // namespace lambent::image
