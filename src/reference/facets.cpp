#include "reference/facets.h"

#include "reference/material_in_double.h"
#include "reference/sample_points.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace lambent::reference {
namespace {

in_double::vec2 to_text(const glm::dvec2& v)
{
    return {v.x, v.y};
}

// Columns: tangent, bitangent and normal.
in_double::mat3 frame_of(const Facets& f)
{
    return f.is_stretched() ? in_double::frame_along(to_text(f.normal), to_text(f.tangent))
                            : in_double::orthonormal_frame(to_text(f.normal));
}

} // namespace

glm::dvec3 Facets::value(const glm::dvec3& light) const
{
    const double NL = glm::dot(normal, light);
    if (!(NL > 0.0))
        return glm::dvec3(0.0);
    const in_double::Metallic m{to_text(base), metalness, to_text(alpha), to_text(tangent), compensation};
    const in_double::vec2 parts = to_text(albedo);
    const in_double::vec3 V = to_text(view), L = to_text(light);
    return NL * from_text(is_stretched() ? in_double::brdf_metallic(m, parts, frame_of(*this), V, L)
                                         : in_double::brdf_metallic(m, parts, to_text(normal), V, L));
}

glm::dvec3 Facets::share() const
{
    const in_double::Metallic m{to_text(base), metalness, to_text(alpha), to_text(tangent), compensation};
    const in_double::Reflectance r = in_double::reflectance_metallic(m, to_text(albedo));
    return from_text(r.plain) + from_text(r.grazing) + from_text(r.diffuse);
}

double Facets::density(const glm::dvec3& light) const
{
    const glm::dvec3 sum = view + light;
    const double length = glm::length(sum);
    if (!(length > 1e-12))
        return 0.0;
    const double NH = std::min(glm::dot(normal, sum) / length, 1.0);
    if (!(NH > 0.0)) // no facet faces into the surface
        return 0.0;
    const double NV = glm::dot(normal, view);
    if (!is_stretched())
        return in_double::density_ggx(NH, alpha.x) * in_double::masking_ggx(NV, alpha.x) / (4.0 * NV);
    const in_double::mat3 frame = frame_of(*this);
    const double D =
        in_double::density_ggx(in_double::in_frame(frame, to_text(sum / length)), to_text(alpha));
    const double SV = in_double::smith_ggx(in_double::in_frame(frame, to_text(view)), to_text(alpha));
    return D * 0.5 / (NV + SV); // G1 = 2 NV / (NV + SV)
}

glm::dvec3 Facets::draw(const glm::dvec2& u) const
{
    const in_double::mat3 frame = frame_of(*this);
    const in_double::vec2 a = to_text(alpha);
    const in_double::vec3 seen = in_double::stretched_view(in_double::in_frame(frame, to_text(view)), a);
    const in_double::vec3 H = in_double::sample_visible_ggx(seen, a, cap_point(u)).normal;
    return glm::normalize(from_text(in_double::mirrored(frame * H, to_text(view))));
}

} // namespace lambent::reference
