#include "environment/chain/cube_faces.h"

#include "environment/panorama/packed_texel.h"
#include "equations/in_double.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lambent::environment {
namespace {

// A bilinear lookup among the face's own texels, clamped to the outermost texel centres.
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

// Fills a border texel from the face that its direction meets. Diagonally beyond a corner it is the mean of both
// neighbouring faces, each found by moving slightly further along one side.
void fill_border_texel(CubeChain& chain, int level, int face, int x, int y)
{
    const int size = chain.face_size(level);
    const double s = (2.0 * x + 1.0) / size - 1.0, t = (2.0 * y + 1.0) / size - 1.0;
    constexpr double more = 1.0 + 1e-9;
    const bool corner = (x < 0 || x == size) && (y < 0 || y == size);
    const Rgb a = inner_lookup(chain, level, cube_position(cube_direction(face, corner ? more * s : s, t)));
    const Rgb b = corner ? inner_lookup(chain, level, cube_position(cube_direction(face, s, more * t))) : a;
    std::uint16_t* out = chain.halfs() + 3 * chain.texel(level, face, x, y);
    out[0] = to_half(0.5f * (a.r + b.r));
    out[1] = to_half(0.5f * (a.g + b.g));
    out[2] = to_half(0.5f * (a.b + b.b));
}

// RGB of a texel.
using Light = std::array<float, 3>;

Light light_at(const CubeChain& chain, std::size_t texel)
{
    const std::uint16_t* const halfs = chain.halfs() + 3 * texel;
    return {from_half(halfs[0]), from_half(halfs[1]), from_half(halfs[2])};
}

// The texels at one point of an edge: the inner texel of a face and the border texel beyond it, and the same two of the
// other face.
struct EdgeTexels {
    std::size_t inner, border, other_inner, other_border;
};

EdgeTexels edge_texels(const CubeChain& chain, int level, int face, int x, int y)
{
    const int size = chain.face_size(level), last = size - 1;
    constexpr double beyond = 1e-6; // distance past the edge
    const auto coordinate = [size](int i) {
        return i < 0 ? -1.0 - beyond : i >= size ? 1.0 + beyond : (2.0 * i + 1.0) / size - 1.0;
    };
    const FacePosition p = cube_position(cube_direction(face, coordinate(x), coordinate(y)));
    const auto texel = [size, last](double s) {
        return std::clamp(static_cast<int>((s * 0.5 + 0.5) * size), 0, last);
    };
    const bool across_s = std::fabs(p.s) > std::fabs(p.t);
    const int there_x = texel(p.s), there_y = texel(p.t);
    const int border_x = across_s ? (p.s < 0.0 ? -1 : size) : there_x;
    const int border_y = across_s ? there_y : (p.t < 0.0 ? -1 : size);
    return {chain.texel(level, face, std::clamp(x, 0, last), std::clamp(y, 0, last)),
            chain.texel(level, face, x, y), chain.texel(level, p.face, there_x, there_y),
            chain.texel(level, p.face, border_x, border_y)};
}

struct TexelChange {
    std::size_t texel;
    Light light;
};

void store_changes(const std::vector<TexelChange>& changes, CubeChain& chain)
{
    for (const auto& [texel, light] : changes)
        for (std::size_t k = 0; k < 3; ++k)
            chain.halfs()[3 * texel + k] = to_half(std::max(light[k], 0.0f));
}

// Lookups on an edge, half way between the inner and the border texel, must agree between both faces: their difference
// is split equally between the two borders.
void join_edges(CubeChain& chain, int level)
{
    const int size = chain.face_size(level);
    std::array<std::vector<TexelChange>, 6> changes; // by face
    tbb::parallel_for(0, 6, [&](int face) {
        for (int i = 0; i < size; ++i)
            for (const auto& [x, y] : {std::pair(i, -1), {i, size}, {-1, i}, {size, i}}) {
                const EdgeTexels at = edge_texels(chain, level, face, x, y);
                const Light inner = light_at(chain, at.inner), border = light_at(chain, at.border);
                const Light other = light_at(chain, at.other_inner),
                            beyond = light_at(chain, at.other_border);
                Light joined;
                for (std::size_t k = 0; k < 3; ++k)
                    joined[k] = 0.5f * (other[k] + beyond[k] + border[k] - inner[k]);
                changes[static_cast<std::size_t>(face)].push_back({at.border, joined});
            }
    });
    for (const std::vector<TexelChange>& of_face : changes)
        store_changes(of_face, chain);
}

// The same for the corners, where three faces meet and each reads the mean of four texels.
void join_corners(CubeChain& chain, int level)
{
    const int size = chain.face_size(level);
    std::array<Light, 8> sums{}; // by the signs of the axes
    struct Corner {
        std::size_t vertex, border;
        Light rest;
    };
    std::vector<Corner> corners;
    for (int face = 0; face < 6; ++face)
        for (const int x : {-1, size})
            for (const int y : {-1, size}) {
                const Direction d = cube_direction(face, x < 0 ? -1.0 : 1.0, y < 0 ? -1.0 : 1.0);
                const std::size_t vertex =
                    (d.x < 0.0 ? 1u : 0u) + (d.y < 0.0 ? 2u : 0u) + (d.z < 0.0 ? 4u : 0u);
                const int inner_x = std::clamp(x, 0, size - 1), inner_y = std::clamp(y, 0, size - 1);
                const Light a = light_at(chain, chain.texel(level, face, inner_x, inner_y)),
                            b = light_at(chain, chain.texel(level, face, x, inner_y)),
                            c = light_at(chain, chain.texel(level, face, inner_x, y));
                corners.push_back({vertex, chain.texel(level, face, x, y), {}});
                const Light own = light_at(chain, corners.back().border);
                for (std::size_t k = 0; k < 3; ++k) {
                    corners.back().rest[k] = a[k] + b[k] + c[k];
                    sums[vertex][k] += (corners.back().rest[k] + own[k]) / 3.0f;
                }
            }
    std::vector<TexelChange> changes;
    for (const Corner& corner : corners) {
        const Light& sum = sums[corner.vertex];
        changes.push_back(
            {corner.border, {sum[0] - corner.rest[0], sum[1] - corner.rest[1], sum[2] - corner.rest[2]}});
    }
    store_changes(changes, chain);
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
    tbb::parallel_for(0, 6, [&](int face) {
        for (int i = -1; i <= size; ++i) {
            fill_border_texel(chain, level, face, i, -1);
            fill_border_texel(chain, level, face, i, size);
            fill_border_texel(chain, level, face, -1, i);
            fill_border_texel(chain, level, face, size, i);
        }
    });
    join_edges(chain, level);
    join_corners(chain, level);
}

} // namespace lambent::environment
