#include "reference/lens.h"

#include "equations/in_double.h"

#include <glm/geometric.hpp>

namespace lambent::reference {

Lens::Lens(const view::Camera& camera, int width, int height)
    : map_(view::ray_map(camera, width, height)), width_(width), height_(height)
{
}

Lens::Lens(const glm::vec3& viewpoint, int width, int height)
    : viewpoint_(viewpoint), width_(width), height_(height)
{
}

SightRay Lens::through(double x, double y) const
{
    if (!map_) {
        const in_double::vec3 d = in_double::direction_from_equirectangular({x / width_, y / height_});
        return {.origin = viewpoint_, .direction = {d.x, d.y, d.z}};
    }
    const glm::dvec3 origin =
        glm::dvec3(map_->origin) + x * glm::dvec3(map_->origin_dx) + y * glm::dvec3(map_->origin_dy);
    const glm::dvec3 direction =
        glm::dvec3(map_->direction) + x * glm::dvec3(map_->direction_dx) + y * glm::dvec3(map_->direction_dy);
    const double length = glm::length(direction);
    return {origin, glm::normalize(direction), length * static_cast<double>(map_->near),
            length * static_cast<double>(map_->far)};
}

} // namespace lambent::reference
