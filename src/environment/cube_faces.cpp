#include "environment/cube_faces.h"

#include "environment/packed_texel.h"
#include "equations/in_double.h"

#include <algorithm>
#include <cmath>

namespace lambent::environment {
namespace {

// Copies to a border texel, but no corner, the one that lies behind the same place of the edge.
void fill_border_texel(CubeChain& chain, int level, int face, int x, int y)
{
    const int size = chain.face_size(level);
    constexpr double beyond = 1e-6; // of an edge
    const auto coordinate = [size](int i) {
        return i < 0 ? -1.0 - beyond : i >= size ? 1.0 + beyond : (2.0 * i + 1.0) / size - 1.0;
    };
    const FacePosition p = cube_position(cube_direction(face, coordinate(x), coordinate(y)));
    const auto texel = [size](double s) {
        return std::clamp(static_cast<int>((s * 0.5 + 0.5) * size), 0, size - 1);
    };
    std::copy_n(chain.halfs() + 3 * chain.texel(level, p.face, texel(p.s), texel(p.t)), 3,
                chain.halfs() + 3 * chain.texel(level, face, x, y));
}

// Three faces meet where four texels would: the fourth is their mean. `x`, `y`: -1 or the face's size.
void fill_corner(CubeChain& chain, int level, int face, int x, int y)
{
    const int last = chain.face_size(level) - 1, inner_x = std::clamp(x, 0, last),
              inner_y = std::clamp(y, 0, last);
    const std::uint16_t* const halfs = chain.halfs();
    const std::size_t own = 3 * chain.texel(level, face, inner_x, inner_y),
                      beside = 3 * chain.texel(level, face, x, inner_y),
                      above = 3 * chain.texel(level, face, inner_x, y);
    std::uint16_t* const out = chain.halfs() + 3 * chain.texel(level, face, x, y);
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = to_half(
            (from_half(halfs[own + k]) + from_half(halfs[beside + k]) + from_half(halfs[above + k])) / 3.0f);
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
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < size; ++i) {
            fill_border_texel(chain, level, face, i, -1);
            fill_border_texel(chain, level, face, i, size);
            fill_border_texel(chain, level, face, -1, i);
            fill_border_texel(chain, level, face, size, i);
        }
        for (const int x : {-1, size})
            for (const int y : {-1, size})
                fill_corner(chain, level, face, x, y);
    }
}

} // namespace lambent::environment
