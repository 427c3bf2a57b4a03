#include "reference/material.h"

#include "image/luminance.h"
#include "reference/material_in_double.h"

#include <glm/geometric.hpp>

namespace lambent::reference {
namespace {

// Facets and strength, 0 to 1, of a lobe over the base, as its row in the list defines them.
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
    return {{in_double::vec3(0.0), 0.0, in_double::vec2(1.0), in_double::vec3(0.0), 0.0}, 0.0};
}

bool takes_layers(view::Model model)
{
    switch (model) {
#define BASE(name, number, layered)                                                                          \
    case view::Model::name:                                                                                  \
        return layered != 0;
#include "shading/passes/bases.h"
    }
    return false;
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
    : surface_(surface), base_(base_of(surface, model, energy_compensation ? 1.0 : 0.0))
{
    if (!takes_layers(model))
        return;
    double below =
        std::visit([](const auto& base) { return base.parts().glossy + base.parts().diffuse; }, base_);
    for (const PointLayer& layer : surface.layers)
        add(layer, energy_compensation ? 1.0 : 0.0, below);
}

// `below`: luminance reflected by the lobes so far; on return including the added one.
void Reflection::add(const PointLayer& layer, double compensation, double& below)
{
    const ListedLobe lobe = listed_lobe(surface_.material, layer.number, compensation);
    const in_double::Metallic& facets = lobe.facets;
    const in_double::vec2 albedo =
        in_double::albedo_of(glm::dot(layer.normal, surface_.view), facets.alpha.x);
    Layer added;
    added.facets.normal = layer.normal;
    added.facets.view = surface_.view;
    added.facets.base = from_text(facets.base);
    added.facets.metalness = facets.metalness;
    added.facets.alpha = {facets.alpha.x, facets.alpha.y};
    added.facets.tangent = from_text(facets.tangent);
    added.facets.compensation = compensation;
    added.facets.albedo = {albedo.x, albedo.y};
    added.there = lobe.there;
    added.left = from_text(in_double::left_below(lobe.there, lobe.facets, albedo));
    const double left = image::luminance(added.left.x, added.left.y, added.left.z);
    added.chance = chance_of(1.0 - left, left * below);
    below = 1.0 - left + left * below;
    layers_.push_back(added);
}

glm::dvec3 Reflection::value(const glm::dvec3& light) const
{
    glm::dvec3 value = std::visit([&](const auto& base) { return base.value(light); }, base_);
    for (const Layer& layer : layers_)
        value = layer.there * layer.facets.value(light) + layer.left * value;
    return value;
}

glm::dvec3 Reflection::albedo() const
{
    glm::dvec3 albedo = std::visit([](const auto& base) { return base.albedo(); }, base_);
    for (const Layer& layer : layers_)
        albedo = layer.there * layer.facets.share() + layer.left * albedo;
    return albedo;
}

double Reflection::density(const glm::dvec3& light) const
{
    double density = std::visit([&](const auto& base) { return base.density(light); }, base_);
    for (const Layer& layer : layers_)
        density = layer.chance * layer.facets.density(light) + (1.0 - layer.chance) * density;
    return density;
}

bool Reflection::is_wide() const
{
    constexpr double least_alpha = 0.05, least_diffuse = 0.05;
    return std::visit(
        [](const auto& base) { return base.alpha() > least_alpha || base.parts().diffuse > least_diffuse; },
        base_);
}

glm::dvec3 Reflection::draw(const glm::dvec2& u) const
{
    double x = u.x;
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
        if (x < layer->chance)
            return layer->facets.draw({x / layer->chance, u.y});
        x = (x - layer->chance) / (1.0 - layer->chance);
    }
    return std::visit([&](const auto& base) { return base.draw({x, u.y}); }, base_);
}

} // namespace lambent::reference
