#include "reference/facets.h"

#include "reference/material_in_double.h"
#include "reference/sample_points.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace lambent::reference {

glm::dvec3 Facets::value(const glm::dvec3& light) const
{
    const double NL = glm::dot(normal, light);
    if (!(NL > 0.0))
        return glm::dvec3(0.0);
    return NL * from_text(in_double::brdf_metallic({to_text(base), metalness, alpha, compensation},
                                                   {albedo.x, albedo.y}, to_text(normal), to_text(view),
                                                   to_text(light)));
}

double Facets::density(const glm::dvec3& light) const
{
    const glm::dvec3 sum = view + light;
    const double length = glm::length(sum);
    if (!(length > 1e-12))
        return 0.0;
    const double NH = std::min(glm::dot(normal, sum) / length, 1.0);
    if (!(NH > 0.0)) // facets that face into the surface are not there
        return 0.0;
    const double NV = glm::dot(normal, view);
    return in_double::density_ggx(NH, alpha) * in_double::masking_ggx(NV, alpha) / (4.0 * NV);
}

glm::dvec3 Facets::draw(const glm::dvec2& u) const
{
    const in_double::mat3 frame = in_double::orthonormal_frame(to_text(normal));
    const in_double::vec3 seen = in_double::in_frame(frame, to_text(view));
    const in_double::vec3 H =
        in_double::sample_visible_ggx(in_double::stretched_view(seen, alpha), alpha, cap_point(u)).normal;
    return glm::normalize(from_text(in_double::mirrored(frame * H, to_text(view))));
}

} // namespace lambent::reference
