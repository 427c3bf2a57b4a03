#include "image/luminance.h"
#include "reference/bases.h"
#include "reference/material.h"
#include "reference/material_in_double.h"
#include "reference/sample_points.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::reference {

// The report's model has no compensation for light scattered more than once.
Base<view::Model::phong>::Base(const Surface& surface, double /*compensation*/)
    : normal_(surface.normal), view_(surface.view), phong_(surface.phong)
{
    const in_double::vec3 fresnel =
        in_double::fresnel_schlick(to_text(phong_.specular), glm::dot(normal_, view_));
    parts_.glossy = image::luminance(fresnel.x, fresnel.y, fresnel.z);
    parts_.diffuse = image::luminance(phong_.diffuse.x, phong_.diffuse.y, phong_.diffuse.z);
    parts_.glossy_share = parts_.diffuse > 0.0 ? chance_of(parts_.glossy, parts_.diffuse) : 1.0;
}

double Base<view::Model::phong>::alpha() const
{
    return in_double::phong_alpha(phong_.exponent);
}

// The diffuse colour, and the facets' reflectance at the angle of the mirrored view.
glm::dvec3 Base<view::Model::phong>::albedo() const
{
    return phong_.diffuse +
           from_text(in_double::fresnel_schlick(to_text(phong_.specular), glm::dot(normal_, view_)));
}

glm::dvec3 Base<view::Model::phong>::value(const glm::dvec3& light) const
{
    const double NL = glm::dot(normal_, light);
    if (!(NL > 0.0))
        return glm::dvec3(0.0);
    return NL * from_text(in_double::brdf_phong(
                    {to_text(phong_.diffuse), to_text(phong_.specular), phong_.exponent}, to_text(normal_),
                    to_text(view_), to_text(light)));
}

double Base<view::Model::phong>::glossy_density(const glm::dvec3& light) const
{
    const glm::dvec3 sum = view_ + light;
    const double length = glm::length(sum);
    if (!(length > 1e-12))
        return 0.0;
    const double NH = std::min(glm::dot(normal_, sum) / length, 1.0);
    const double VH = glm::dot(view_, sum) / length, exponent = phong_.exponent;
    // Sampled facets may face away from the viewer: NH is then negative, and they reflect to below the surface.
    const double lobe = (exponent + 1.0) / (2.0 * std::numbers::pi) * std::pow(std::fabs(NH), exponent);
    return VH > 1e-9 ? lobe / (4.0 * VH) : 0.0;
}

double Base<view::Model::phong>::density(const glm::dvec3& light) const
{
    const double share = parts_.glossy_share;
    return share * glossy_density(light) + (1.0 - share) * cosine_density(normal_, light);
}

glm::dvec3 Base<view::Model::phong>::draw_glossy(const glm::dvec2& u) const
{
    const in_double::mat3 frame = in_double::orthonormal_frame(to_text(normal_));
    in_double::vec3 point = cap_point(u);
    point.x = std::log2(std::max(1.0 - u.y, 1e-300));
    const in_double::vec3 H = in_double::sample_phong(point, phong_.exponent);
    return glm::normalize(from_text(in_double::mirrored(frame * H, to_text(view_))));
}

// u.x selects the part and is then rescaled to [0, 1) for the direction, so that directions stay evenly distributed.
glm::dvec3 Base<view::Model::phong>::draw(const glm::dvec2& u) const
{
    const double share = parts_.glossy_share;
    if (u.x < share)
        return draw_glossy({u.x / share, u.y});
    return draw_cosine(normal_, {(u.x - share) / (1.0 - share), u.y});
}

} // namespace lambent::reference
