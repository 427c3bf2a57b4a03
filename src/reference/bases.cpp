#include "reference/bases.h"

#include "reference/material.h"
#include "reference/material_in_double.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::reference {

using std::numbers::pi;

AnyBase base_of(const Surface& surface, view::Model model, double compensation)
{
    switch (model) {
#define BASE(name, number, layered)                                                                          \
    case view::Model::name:                                                                                  \
        return Base<view::Model::name>(surface, compensation);
#include "shading/passes/bases.h"
    }
    return Base<view::Model::ggx>(surface, compensation);
}

double chance_of(double part, double rest)
{
    return std::clamp(part / std::max(part + rest, 1e-12), 0.1, 0.9);
}

double cosine_density(const glm::dvec3& normal, const glm::dvec3& light)
{
    return std::max(glm::dot(normal, light), 0.0) / pi;
}

// Samples the unit disc uniformly and projects the point up onto the hemisphere.
glm::dvec3 draw_cosine(const glm::dvec3& normal, const glm::dvec2& u)
{
    const double r = std::sqrt(u.y);
    const in_double::vec3 d{r * std::cos(2.0 * pi * u.x), r * std::sin(2.0 * pi * u.x),
                            std::sqrt(std::max(1.0 - u.y, 0.0))};
    return from_text(in_double::orthonormal_frame(to_text(normal)) * d);
}

} // namespace lambent::reference
