#include "environment/cube_faces.h"

#include "environment/packed_texel.h"
#include "equations/in_double.h"

#include <algorithm>
#include <cmath>

namespace lambent::environment {
namespace {

// Bilinear among the face's own texels: beyond the outermost centres the outermost texel goes on.
Rgb inner_lookup(const CubeChain& chain, int level, const FacePosition& p)
{
    const int size = chain.face_size(level);
    const double last = size - 1;
    const double x = std::clamp((p.s * 0.5 + 0.5) * size - 0.5, 0.0, last);
    const double y = std::clamp((p.t * 0.5 + 0.5) * size - 0.5, 0.0, last);
    const int x0 = std::min(static_cast<int>(x), std::max(size - 2, 0));
    const int y0 = std::min(static_cast<int>(y), std::max(size - 2, 0));
    const int x1 = std::min(x0 + 1, size - 1), y1 = std::min(y0 + 1, size - 1);
    const double fx = x - x0, fy = y - y0;
    const auto channel = [&](std::size_t c) {
        const auto at = [&](int i, int j) {
            return static_cast<double>(from_half(chain.halfs()[3 * chain.texel(level, p.face, i, j) + c]));
        };
        return static_cast<float>((at(x0, y0) * (1 - fx) + at(x1, y0) * fx) * (1 - fy) +
                                  (at(x0, y1) * (1 - fx) + at(x1, y1) * fx) * fy);
    };
    return {channel(0), channel(1), channel(2)};
}

void fill_border_texel(CubeChain& chain, int level, int face, int x, int y)
{
    const int size = chain.face_size(level);
    const double s = (2.0 * x + 1.0) / size - 1.0, t = (2.0 * y + 1.0) / size - 1.0;
    const Rgb c = inner_lookup(chain, level, cube_position(cube_direction(face, s, t)));
    std::uint16_t* out = chain.halfs() + 3 * chain.texel(level, face, x, y);
    out[0] = to_half(c.r);
    out[1] = to_half(c.g);
    out[2] = to_half(c.b);
}

} // namespace

Direction cube_direction(int face, double s, double t)
{
    const in_double::vec3 d = in_double::normalize(in_double::direction_from_cube(face, s, t));
    return {d.x, d.y, d.z};
}

FacePosition cube_position(const Direction& d)
{
    const in_double::CubePlace p = in_double::cube_from_direction({d.x, d.y, d.z});
    return {static_cast<int>(p.face), p.s, p.t};
}

double cube_texel_solid_angle(int size, int x, int y)
{
    const double x0 = 2.0 * x / size - 1.0, x1 = 2.0 * (x + 1) / size - 1.0;
    const double y0 = 2.0 * y / size - 1.0, y1 = 2.0 * (y + 1) / size - 1.0;
    using in_double::cube_corner_solid_angle;
    return cube_corner_solid_angle(x0, y0) - cube_corner_solid_angle(x0, y1) -
           cube_corner_solid_angle(x1, y0) + cube_corner_solid_angle(x1, y1);
}

void fill_borders(CubeChain& chain, int level)
{
    const int size = chain.face_size(level);
    for (int face = 0; face < 6; ++face)
        for (int i = -1; i <= size; ++i) {
            fill_border_texel(chain, level, face, i, -1);
            fill_border_texel(chain, level, face, i, size);
            fill_border_texel(chain, level, face, -1, i);
            fill_border_texel(chain, level, face, size, i);
        }
}

} // namespace lambent::environment
