#include "image/luminance.h"
#include "reference/bases.h"
#include "reference/material.h"
#include "reference/material_in_double.h"

#include <glm/geometric.hpp>

namespace lambent::reference {

Base<view::Model::ggx>::Base(const Surface& surface, double compensation)
{
    const PointMaterial& m = surface.material;
    const in_double::vec2 albedo = in_double::albedo_of(glm::dot(surface.normal, surface.view), m.alpha);
    facets_.normal = surface.normal;
    facets_.view = surface.view;
    facets_.base = m.base_color;
    facets_.metalness = m.metallic;
    facets_.alpha = glm::dvec2(m.alpha);
    facets_.compensation = compensation;
    facets_.albedo = {albedo.x, albedo.y};
    const in_double::Reflectance r = in_double::reflectance_metallic(
        {to_text(m.base_color), m.metallic, in_double::vec2(m.alpha), in_double::vec3(0.0), compensation},
        albedo);
    parts_.glossy = image::luminance(r.plain.x, r.plain.y, r.plain.z) +
                    image::luminance(r.grazing.x, r.grazing.y, r.grazing.z);
    parts_.diffuse = image::luminance(r.diffuse.x, r.diffuse.y, r.diffuse.z);
    // Visible normals of a rough surface often reflect to below it. Without a diffuse part, a share of directions that
    // grows with roughness is therefore sampled by the cosine.
    parts_.glossy_share =
        parts_.diffuse > 0.0 ? chance_of(parts_.glossy, parts_.diffuse) : 1.0 - 0.5 * m.alpha * m.alpha;
}

double Base<view::Model::ggx>::density(const glm::dvec3& light) const
{
    const double share = parts_.glossy_share;
    return share * facets_.density(light) + (1.0 - share) * cosine_density(facets_.normal, light);
}

// u.x selects the part and is then rescaled to [0, 1) for the direction, so that directions stay evenly distributed.
glm::dvec3 Base<view::Model::ggx>::draw(const glm::dvec2& u) const
{
    const double share = parts_.glossy_share;
    if (u.x < share)
        return facets_.draw({u.x / share, u.y});
    return draw_cosine(facets_.normal, {(u.x - share) / (1.0 - share), u.y});
}

} // namespace lambent::reference
