#include "reference/material.h"

#include "albedo/albedo_table.h"
#include "equations/in_double.h"
#include "image/luminance.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::reference {
namespace {

using std::numbers::pi;

in_double::vec3 text(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

glm::dvec3 vec(const in_double::vec3& v)
{
    return {v.x, v.y, v.z};
}

double luminance(const in_double::vec3& c)
{
    return image::luminance(c.x, c.y, c.z);
}

in_double::Metallic metallic(const Surface& s, double compensation)
{
    return {text(s.base), s.metalness, s.gloss, compensation};
}

// (xi2, cos 2 pi xi1, sin 2 pi xi1), as the text's samplers want it.
in_double::vec3 cap_point(const glm::dvec2& u)
{
    return {u.y, std::cos(2.0 * pi * u.x), std::sin(2.0 * pi * u.x)};
}

// Uniform on the disc, lifted onto the hemisphere. [Malley; Pharr, Jakob and Humphreys 2016, 13.6.3]
in_double::vec3 cosine_direction(const glm::dvec2& u)
{
    const double r = std::sqrt(u.y);
    return {r * std::cos(2.0 * pi * u.x), r * std::sin(2.0 * pi * u.x), std::sqrt(std::max(1.0 - u.y, 0.0))};
}

} // namespace

glm::dvec2 directional_albedo(double NV, double alpha)
{
    constexpr int n = albedo_table_size;
    const double x = std::sqrt(std::clamp(NV, 0.0, 1.0)) * (n - 1);
    const double y = std::sqrt(std::clamp(alpha, 0.0, 1.0)) * (n - 1);
    const int x0 = std::min(static_cast<int>(x), n - 2), y0 = std::min(static_cast<int>(y), n - 2);
    const float* at = albedo_table + 2 * (y0 * n + x0);
    const auto part = [&](int i) {
        const double upper = std::lerp(static_cast<double>(at[i]), static_cast<double>(at[2 + i]), x - x0);
        const double lower =
            std::lerp(static_cast<double>(at[2 * n + i]), static_cast<double>(at[2 * n + 2 + i]), x - x0);
        return std::lerp(upper, lower, y - y0);
    };
    return {part(0), part(1)};
}

Reflection::Reflection(const Surface& surface, view::Model model, bool energy_compensation)
    : surface_(surface), model_(model), compensation_(energy_compensation ? 1.0 : 0.0),
      NV_(glm::dot(surface.normal, surface.view))
{
    double glossy;
    if (model == view::Model::ggx) {
        albedo_ = directional_albedo(NV_, surface.gloss);
        const in_double::Reflectance r =
            in_double::reflectance_metallic(metallic(surface, compensation_), {albedo_.x, albedo_.y});
        glossy = luminance(r.plain) + luminance(r.grazing);
        diffuse_ = luminance(r.diffuse);
    } else {
        glossy = luminance(in_double::fresnel_schlick(text(surface.specular), NV_));
        diffuse_ = luminance(text(surface.base));
    }
    // Rough metals, whose visible normals often mirror below the surface, get some directions by the cosine as well.
    const double most = model == view::Model::ggx ? 1.0 - 0.5 * surface.gloss * surface.gloss : 1.0;
    // Neither is left out altogether, unless it is nothing at all: colours differ from their luminance.
    glossy_share_ = diffuse_ > 0.0 ? std::clamp(glossy / std::max(glossy + diffuse_, 1e-12), 0.1, 0.9) : most;
}

glm::dvec3 Reflection::value(const glm::dvec3& light) const
{
    const double NL = glm::dot(surface_.normal, light);
    if (!(NL > 0.0))
        return glm::dvec3(0.0);
    const in_double::vec3 N = text(surface_.normal), V = text(surface_.view), L = text(light);
    if (model_ == view::Model::ggx)
        return NL * vec(in_double::brdf_metallic(metallic(surface_, compensation_), {albedo_.x, albedo_.y}, N,
                                                 V, L));
    return NL * vec(in_double::brdf_phong({text(surface_.base), text(surface_.specular), surface_.gloss}, N,
                                          V, L));
}

double Reflection::glossy_density(const glm::dvec3& light) const
{
    const glm::dvec3 sum = surface_.view + light;
    const double length = glm::length(sum);
    if (!(length > 1e-12))
        return 0.0;
    const double NH = std::min(glm::dot(surface_.normal, sum) / length, 1.0);
    if (model_ == view::Model::ggx) {
        if (!(NH > 0.0)) // facets that face into the surface are not there
            return 0.0;
        return in_double::density_ggx(NH, surface_.gloss) * in_double::masking_ggx(NV_, surface_.gloss) /
               (4.0 * NV_);
    }
    const double VH = glm::dot(surface_.view, sum) / length;
    // Facets are drawn that face away from the viewer, too: they mirror to below the surface.
    const double lobe = (surface_.gloss + 1.0) / (2.0 * pi) * std::pow(std::fabs(NH), surface_.gloss);
    return VH > 1e-9 ? lobe / (4.0 * VH) : 0.0;
}

bool Reflection::is_wide() const
{
    constexpr double least_alpha = 0.05, least_diffuse = 0.05;
    const double alpha = model_ == view::Model::ggx ? surface_.gloss : in_double::phong_alpha(surface_.gloss);
    return alpha > least_alpha || diffuse_ > least_diffuse;
}

double Reflection::density(const glm::dvec3& light) const
{
    const double cosine = std::max(glm::dot(surface_.normal, light), 0.0) / pi;
    return glossy_share_ * glossy_density(light) + (1.0 - glossy_share_) * cosine;
}

glm::dvec3 Reflection::draw_glossy(const glm::dvec2& u) const
{
    const in_double::mat3 frame = in_double::orthonormal_frame(text(surface_.normal));
    in_double::vec3 H(0.0);
    if (model_ == view::Model::ggx) {
        const in_double::vec3 view = in_double::in_frame(frame, text(surface_.view));
        H = in_double::sample_visible_ggx(in_double::stretched_view(view, surface_.gloss), surface_.gloss,
                                          cap_point(u))
                .normal;
    } else {
        in_double::vec3 point = cap_point(u);
        point.x = std::log2(std::max(1.0 - u.y, 1e-300));
        H = in_double::sample_phong(point, surface_.gloss);
    }
    return glm::normalize(vec(in_double::mirrored(frame * H, text(surface_.view))));
}

glm::dvec3 Reflection::draw(const glm::dvec2& u) const
{
    // One number chooses the part and, stretched again, the direction: it stays evenly spread.
    if (u.x < glossy_share_)
        return draw_glossy({u.x / glossy_share_, u.y});
    const double x = (u.x - glossy_share_) / (1.0 - glossy_share_);
    return vec(in_double::orthonormal_frame(text(surface_.normal)) * cosine_direction({x, u.y}));
}

} // namespace lambent::reference
