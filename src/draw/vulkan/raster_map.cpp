#include "draw/vulkan/raster_map.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace lambent::draw {
namespace {

// Rows over (P - origin, 1) for a point P that is seen through the position (x, y) at the distance t.
struct Seen {
    glm::dvec4 t, tx, ty; // perspective: t, t x, t y; orthographic: t, x, y
};

std::optional<glm::dmat3> inverse_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dmat3 columns(a, b, c);
    const double volume = std::fabs(glm::determinant(columns));
    const double most = glm::length(a) * glm::length(b) * glm::length(c);
    if (!(volume > 1e-12 * most) || !std::isfinite(most))
        return std::nullopt;
    return glm::inverse(columns);
}

glm::dvec4 row(const glm::dmat3& m, int i)
{
    return {m[0][i], m[1][i], m[2][i], 0.0};
}

double furthest(const glm::dvec4& t, const glm::dvec3& origin, const scene::Bounds& bounds)
{
    double most = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? bounds.low.x : bounds.high.x,
                           (corner & 2) != 0 ? bounds.low.y : bounds.high.y,
                           (corner & 4) != 0 ? bounds.low.z : bounds.high.z);
        most = std::max(most, glm::dot(t, glm::dvec4(p - origin, 1.0)));
    }
    return most;
}

constexpr glm::dvec4 one(0.0, 0.0, 0.0, 1.0);

// Depth times t; depth is 1 at `near` and 0 at `far`. If nothing lies beyond `far`, depth is near / t, whose relative
// precision is the same at all distances.
glm::dvec4 perspective_depth(const glm::dvec4& t, double near, double far, double most)
{
    return far < most ? near / (far - near) * (far * one - t) : near * one;
}

glm::dvec4 flat_depth(const glm::dvec4& t, double near, double far)
{
    return far / (far - near) * one - t / (far - near);
}

// One axis of clip space: positions in the window, mapped to [-1, 1], times w.
gpu_layout::vec4 across(const glm::dvec4& place, const glm::dvec4& w, double first, int size)
{
    return gpu_layout::vec4((2.0 / size) * (place - first * w) - w);
}

} // namespace

std::optional<gpu_layout::RasterConstants> raster_map(const RayMap& rays, const RasterWindow& window,
                                                      const scene::Bounds& bounds)
{
    const glm::dvec3 origin(rays.origin), direction(rays.direction);
    const bool perspective = rays.origin_dx == glm::vec3(0.0f) && rays.origin_dy == glm::vec3(0.0f);
    const glm::dvec3 dx(perspective ? rays.direction_dx : rays.origin_dx),
        dy(perspective ? rays.direction_dy : rays.origin_dy);
    const std::optional<glm::dmat3> inverse = inverse_of(direction, dx, dy);
    if (!inverse)
        return std::nullopt;
    const Seen seen = {row(*inverse, 0), row(*inverse, 1), row(*inverse, 2)};
    const glm::dvec4 w = perspective ? seen.t : one;
    const double most = furthest(seen.t, origin, bounds);
    if (!(most > 0.0) || !std::isfinite(most))
        return std::nullopt;
    const double near = static_cast<double>(rays.near), far = static_cast<double>(rays.far);
    if (!(near < most))
        return std::nullopt;
    gpu_layout::RasterConstants map{};
    map.row_x = across(seen.tx, w, window.x + static_cast<double>(window.place.x) - 0.5, window.width);
    map.row_y = across(seen.ty, w, window.y + static_cast<double>(window.place.y) - 0.5, window.height);
    map.row_z =
        gpu_layout::vec4(perspective ? perspective_depth(seen.t, std::max(near, 1e-7 * most), far, most)
                                     : flat_depth(seen.t, near, std::min(far, 1.001 * most)));
    map.row_w = gpu_layout::vec4(w);
    return map;
}

} // namespace lambent::draw
