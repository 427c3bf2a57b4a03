#include "view/covered_area.h"

#include <glm/ext/matrix_double3x3.hpp>
#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lambent::view {
namespace {

// Where a point is seen, in pixels; nothing if that is not in front of the camera, or nowhere.
std::optional<glm::dvec2> place_of(const glm::dvec3& point, const RayMap& rays)
{
    const glm::dvec3 away = point - glm::dvec3(rays.origin), direction(rays.direction);
    const bool parallel = rays.direction_dx == glm::vec3(0.0f) && rays.direction_dy == glm::vec3(0.0f);
    // away = x origin_dx + y origin_dy + t direction, or t direction + t x direction_dx + t y direction_dy.
    const glm::dmat3 axes =
        parallel ? glm::dmat3(glm::dvec3(rays.origin_dx), glm::dvec3(rays.origin_dy), direction)
                 : glm::dmat3(glm::dvec3(rays.direction_dx), glm::dvec3(rays.direction_dy), direction);
    const glm::dvec3 found = glm::inverse(axes) * away;
    if (!(found.z > 0.0))
        return std::nullopt;
    const glm::dvec2 place = glm::dvec2(found) / (parallel ? 1.0 : found.z);
    return std::isfinite(place.x) && std::isfinite(place.y) ? std::optional(place) : std::nullopt;
}

} // namespace

PixelArea covered_area(const scene::Bounds& bounds, const RayMap& rays, int width, int height)
{
    glm::dvec2 low(width, height), high(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const auto at = [&](int axis) {
            return (corner >> axis & 1) != 0 ? bounds.high[axis] : bounds.low[axis];
        };
        const std::optional<glm::dvec2> place = place_of(glm::dvec3(at(0), at(1), at(2)), rays);
        if (!place)
            return {0, 0, width, height};
        low = glm::min(low, *place);
        high = glm::max(high, *place);
    }
    // Rounding of the rays moves places by less than a pixel.
    const auto within = [](double value, int most) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    PixelArea area{within(std::floor(low.x) - 1.0, width - 1), within(std::floor(low.y) - 1.0, height - 1)};
    area.width = std::max(within(std::ceil(high.x) + 1.0, width) - area.x, 1);
    area.height = std::max(within(std::ceil(high.y) + 1.0, height) - area.y, 1);
    return area;
}

} // namespace lambent::view
