#include "reference/material.h"

#include "image/luminance.h"
#include "reference/material_in_double.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::reference {
namespace {

using std::numbers::pi;

double luminance(const in_double::vec3& c)
{
    return image::luminance(c.x, c.y, c.z);
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

// By the lists: the facets of a lobe over the base, and how much of it there is.
struct ListedLobe {
    in_double::Metallic facets;
    double there;
};

ListedLobe listed_lobe(const PointMaterial& material, [[maybe_unused]] int which,
                       [[maybe_unused]] double compensation)
{
    [[maybe_unused]] const in_double::Material m = to_text(material);
#define LAYER(name, number, texture)                                                                         \
    if (which == number)                                                                                     \
        return {in_double::facets_##name(m, compensation), m.name};
#include "shading/lobes/layers.h"
    return {{in_double::vec3(0.0), 0.0, 1.0, 0.0}, 0.0};
}

// What is worth drawing by chance: seldom what hardly shows, but never not at all, as colours differ from their luminance.
double chance_of(double part, double rest)
{
    return std::clamp(part / std::max(part + rest, 1e-12), 0.1, 0.9);
}

} // namespace

glm::dvec3 emitted_by(const Surface& surface, bool energy_compensation)
{
    if (surface.unlit)
        return surface.material.base_color;
    glm::dvec3 light = surface.material.emissive;
    for (const PointLayer& layer : surface.layers) {
        const ListedLobe lobe = listed_lobe(surface.material, layer.number, energy_compensation ? 1.0 : 0.0);
        light *= from_text(
            in_double::left_below_at(lobe.there, lobe.facets, to_text(layer.normal), to_text(surface.view)));
    }
    return light;
}

Reflection::Reflection(const Surface& surface, view::Model model, bool energy_compensation)
    : surface_(surface), is_phong_(model == view::Model::phong),
      compensation_(energy_compensation ? 1.0 : 0.0)
{
    set_base(model);
    // Rough metals, whose visible normals often mirror below the surface, get some directions by the cosine as well.
    const double most = is_phong_ ? 1.0 : 1.0 - 0.5 * base_.alpha * base_.alpha;
    glossy_share_ = diffuse_ > 0.0 ? chance_of(glossy_, diffuse_) : most;
    if (!is_phong_)
        set_layers();
}

void Reflection::set_base(view::Model model)
{
    const PointMaterial& m = surface_.material;
    base_.normal = surface_.normal;
    base_.NV = glm::dot(surface_.normal, surface_.view);
    if (model == view::Model::phong) {
        base_.alpha = in_double::phong_alpha(surface_.phong.exponent);
        glossy_ = luminance(in_double::fresnel_schlick(to_text(surface_.phong.specular), base_.NV));
        diffuse_ = luminance(to_text(surface_.phong.diffuse));
        return;
    }
    base_.base = m.base_color;
    base_.metalness = m.metallic;
    base_.alpha = m.alpha;
    const in_double::vec2 albedo = in_double::albedo_of(base_.NV, m.alpha);
    base_.albedo = {albedo.x, albedo.y};
    const in_double::Reflectance r =
        in_double::reflectance_metallic({to_text(m.base_color), m.metallic, m.alpha, compensation_}, albedo);
    glossy_ = luminance(r.plain) + luminance(r.grazing);
    diffuse_ = luminance(r.diffuse);
}

Reflection::Facets Reflection::facets_of(const PointLayer& layer) const
{
    const ListedLobe lobe = listed_lobe(surface_.material, layer.number, compensation_);
    Facets f;
    f.normal = layer.normal;
    f.base = from_text(lobe.facets.base);
    f.metalness = lobe.facets.metalness;
    f.alpha = lobe.facets.alpha;
    f.there = lobe.there;
    f.NV = glm::dot(layer.normal, surface_.view);
    const in_double::vec2 albedo = in_double::albedo_of(f.NV, f.alpha);
    f.albedo = {albedo.x, albedo.y};
    f.left = from_text(in_double::left_below(lobe.there, lobe.facets, albedo));
    return f;
}

void Reflection::set_layers()
{
    double below = glossy_ + diffuse_;
    for (const PointLayer& layer : surface_.layers) {
        Facets f = facets_of(layer);
        const double left = luminance(to_text(f.left));
        f.chance = chance_of(1.0 - left, left * below);
        below = 1.0 - left + left * below;
        layers_.push_back(f);
    }
}

glm::dvec3 Reflection::value_of(const Facets& f, const glm::dvec3& light) const
{
    const double NL = glm::dot(f.normal, light);
    if (!(NL > 0.0))
        return glm::dvec3(0.0);
    return NL * from_text(in_double::brdf_metallic({to_text(f.base), f.metalness, f.alpha, compensation_},
                                                   {f.albedo.x, f.albedo.y}, to_text(f.normal),
                                                   to_text(surface_.view), to_text(light)));
}

glm::dvec3 Reflection::base_value(const glm::dvec3& light) const
{
    if (!is_phong_)
        return value_of(base_, light);
    const double NL = glm::dot(surface_.normal, light);
    if (!(NL > 0.0))
        return glm::dvec3(0.0);
    const PointPhong& p = surface_.phong;
    return NL *
           from_text(in_double::brdf_phong({to_text(p.diffuse), to_text(p.specular), p.exponent},
                                           to_text(surface_.normal), to_text(surface_.view), to_text(light)));
}

glm::dvec3 Reflection::value(const glm::dvec3& light) const
{
    glm::dvec3 value = base_value(light);
    for (const Facets& layer : layers_)
        value = layer.there * value_of(layer, light) + layer.left * value;
    return value;
}

double Reflection::density_of(const Facets& f, const glm::dvec3& light) const
{
    const glm::dvec3 sum = surface_.view + light;
    const double length = glm::length(sum);
    if (!(length > 1e-12))
        return 0.0;
    const double NH = std::min(glm::dot(f.normal, sum) / length, 1.0);
    if (!(NH > 0.0)) // facets that face into the surface are not there
        return 0.0;
    return in_double::density_ggx(NH, f.alpha) * in_double::masking_ggx(f.NV, f.alpha) / (4.0 * f.NV);
}

double Reflection::phong_density(const glm::dvec3& light) const
{
    const glm::dvec3 sum = surface_.view + light;
    const double length = glm::length(sum);
    if (!(length > 1e-12))
        return 0.0;
    const double NH = std::min(glm::dot(surface_.normal, sum) / length, 1.0);
    const double VH = glm::dot(surface_.view, sum) / length, exponent = surface_.phong.exponent;
    // Facets are drawn that face away from the viewer, too: they mirror to below the surface.
    const double lobe = (exponent + 1.0) / (2.0 * pi) * std::pow(std::fabs(NH), exponent);
    return VH > 1e-9 ? lobe / (4.0 * VH) : 0.0;
}

double Reflection::base_density(const glm::dvec3& light) const
{
    const double glossy = is_phong_ ? phong_density(light) : density_of(base_, light);
    const double cosine = std::max(glm::dot(surface_.normal, light), 0.0) / pi;
    return glossy_share_ * glossy + (1.0 - glossy_share_) * cosine;
}

double Reflection::density(const glm::dvec3& light) const
{
    double density = base_density(light);
    for (const Facets& layer : layers_)
        density = layer.chance * density_of(layer, light) + (1.0 - layer.chance) * density;
    return density;
}

bool Reflection::is_wide() const
{
    constexpr double least_alpha = 0.05, least_diffuse = 0.05;
    return base_.alpha > least_alpha || diffuse_ > least_diffuse;
}

glm::dvec3 Reflection::draw_facets(const Facets& f, const glm::dvec2& u) const
{
    const in_double::mat3 frame = in_double::orthonormal_frame(to_text(f.normal));
    const in_double::vec3 view = in_double::in_frame(frame, to_text(surface_.view));
    const in_double::vec3 H =
        in_double::sample_visible_ggx(in_double::stretched_view(view, f.alpha), f.alpha, cap_point(u)).normal;
    return glm::normalize(from_text(in_double::mirrored(frame * H, to_text(surface_.view))));
}

glm::dvec3 Reflection::draw_phong(const glm::dvec2& u) const
{
    const in_double::mat3 frame = in_double::orthonormal_frame(to_text(surface_.normal));
    in_double::vec3 point = cap_point(u);
    point.x = std::log2(std::max(1.0 - u.y, 1e-300));
    const in_double::vec3 H = in_double::sample_phong(point, surface_.phong.exponent);
    return glm::normalize(from_text(in_double::mirrored(frame * H, to_text(surface_.view))));
}

// One number chooses the part and, stretched again, the direction: it stays evenly spread.
glm::dvec3 Reflection::draw_base(const glm::dvec2& u) const
{
    if (u.x < glossy_share_) {
        const glm::dvec2 stretched(u.x / glossy_share_, u.y);
        return is_phong_ ? draw_phong(stretched) : draw_facets(base_, stretched);
    }
    const double x = (u.x - glossy_share_) / (1.0 - glossy_share_);
    return from_text(in_double::orthonormal_frame(to_text(surface_.normal)) * cosine_direction({x, u.y}));
}

glm::dvec3 Reflection::draw(const glm::dvec2& u) const
{
    double x = u.x;
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
        if (x < layer->chance)
            return draw_facets(*layer, {x / layer->chance, u.y});
        x = (x - layer->chance) / (1.0 - layer->chance);
    }
    return draw_base({x, u.y});
}

} // namespace lambent::reference
