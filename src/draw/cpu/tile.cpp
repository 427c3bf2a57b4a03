#include "draw/cpu/tile.h"

#include "draw/cpu/light_choice.h"
#include "draw/cpu/specular_kernel.h"
#include "draw/layer_list.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace lambent::draw {

float shown(const scene::Material& material, float opacity)
{
    return material.alpha_mode == scene::AlphaMode::opaque ? 1.0f : std::clamp(opacity, 0.0f, 1.0f);
}

namespace {

// Adds weight * (r, g, b, 1) to a pixel.
void add(float* out, float weight, const glm::vec3& rgb)
{
    out[0] += weight * rgb.r;
    out[1] += weight * rgb.g;
    out[2] += weight * rgb.b;
    out[3] += weight;
}

// The diffuse reflectance by which the irradiance became light; white where there is no light.
glm::vec3 diffuse_albedo(const glm::vec3& ambient, const glm::vec3& irradiance)
{
    glm::vec3 albedo(1.0f);
    for (int c = 0; c < 3; ++c)
        if (irradiance[c] > 0.0f)
            albedo[c] = 3.1415927f * ambient[c] / irradiance[c];
    return albedo;
}

} // namespace

TileDrawer::TileDrawer(const PictureContext& picture)
    : picture_(picture), sight_(picture.scene, picture.prepared.rays)
{
}

void TileDrawer::draw(const TileArea& area, Frame& frame, LightSums* sums)
{
    background_.assign(static_cast<std::size_t>(area.width * area.height), 0.0f);
    look_at_centres(area);
    choose_looks(area);
    for (int wave = 0; wave < most_waves && !looks_.empty(); ++wave) {
        build_fragments();
        shade();
        resolve(frame, area);
        if (sums)
            resolve_classes(*sums, area);
        look_behind();
    }
    for (const Look& look : looks_) // still transparent after the last wave
        background_[look.pixel] += look.weight;
    add_background(frame, area);
}

// Occlusion textures approximate shadows of the environment's light, which pictures with bounces compute.
SurfaceContext PictureContext::surface(std::uint32_t instance) const
{
    SurfaceContext context = scene.surface(instance);
    context.rays = prepared.rays;
    context.model = settings.model;
    context.energy_compensation = settings.energy_compensation;
    context.roughness = settings.roughness_override;
    if (settings.bounces > 0)
        context.textures[texture_occlusion] = nullptr;
    return context;
}

void TileDrawer::find_group(const Fragments::Group& group)
{
    find_surfaces(picture_.surface(group.instance), group.begin, group.end, fragments_);
}

void TileDrawer::darken(const Fragments::Group& group)
{
    for (int c = column_direct; c < columns_of_light_end; ++c)
        std::fill(fragments_[c] + group.begin, fragments_[c] + group.end, 0.0f);
}

scene::Bounds TileDrawer::bounds_of(const Fragments::Group& group) const
{
    scene::Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        const float* const values = fragments_[column_position + axis];
        const auto [low, high] = std::minmax_element(values + group.begin, values + group.end);
        box.low[axis] = *low, box.high[axis] = *high;
    }
    return box;
}

void TileDrawer::light_group(const Fragments::Group& group)
{
    darken(group);
    if (picture_.scene.surface(group.instance).material->unlit)
        return;
    if (!picture_.prepared.lights.empty()) {
        choose_lights(picture_.prepared.lights, bounds_of(group), lights_);
        light_directly(picture_.prepared.light, lights_, group.begin, group.end, fragments_);
    }
    if (picture_.prepared.light.environment) {
        light_ambiently(picture_.prepared.light, group.begin, group.end, fragments_);
        light_specularly(group.small ? picture_.prepared.few_light : picture_.prepared.light, group.begin,
                         group.end, fragments_);
    }
}

void TileDrawer::shade()
{
    for (const Fragments::Group& group : fragments_.groups) {
        find_group(group);
        light_group(group);
    }
}

void TileDrawer::resolve(Frame& frame, const TileArea& area)
{
    const std::vector<LayerSource> sources =
        picture_.settings.layers ? layer_sources(picture_.settings.model) : std::vector<LayerSource>();
    const auto three = [&](int first, std::size_t at) {
        return glm::vec3(fragments_[first][at], fragments_[first + 1][at], fragments_[first + 2][at]);
    };
    const auto layer_value = [&](const LayerSource& source, std::size_t at) {
        if (source.reading == Reading::three)
            return three(source.first, at);
        const float value = fragments_[source.first][at];
        return glm::vec3(source.reading == Reading::root ? std::sqrt(value) : value);
    };
    for (const Fragments::Group& group : fragments_.groups) {
        const scene::Material& material = *picture_.scene.surface(group.instance).material;
        for (std::size_t at = group.begin; at < group.end; ++at) {
            const float weight = fragments_.weight[at] * shown(material, fragments_[column_opacity][at]);
            if (weight <= 0.0f)
                continue;
            const int pixel = static_cast<int>(fragments_.pixel[at]);
            const glm::ivec2 place(area.x + pixel % area.width, area.y + pixel / area.width);
            float* const out = frame.radiance.pixel(place.x, place.y);
            if (material.unlit)
                add(frame.radiance.unlit.data() + (out - frame.radiance.values.data()), weight,
                    three(column_emissive, at));
            add(out, weight,
                three(column_emissive, at) + three(column_direct, at) + three(column_ambient, at) +
                    three(column_reflected, at));
            for (std::size_t i = 0; i < sources.size(); ++i)
                add(frame.layers[i].image.pixel(place.x, place.y), weight, layer_value(sources[i], at));
        }
    }
}

// Adds what pixels show to the sums, as resolve() adds it to the frame.
void TileDrawer::resolve_classes(LightSums& sums, const TileArea& area) const
{
    const Fragments& f = fragments_;
    const auto three = [&](int first, std::size_t at) {
        return glm::vec3(f[first][at], f[first + 1][at], f[first + 2][at]);
    };
    denoise::Guides& guides = sums.picture.guides;
    for (const Fragments::Group& group : f.groups) {
        const scene::Material& material = *picture_.scene.surface(group.instance).material;
        for (std::size_t at = group.begin; at < group.end; ++at) {
            const float weight = f.weight[at] * shown(material, f[column_opacity][at]);
            if (weight <= 0.0f || material.unlit)
                continue;
            const int place = static_cast<int>(f.pixel[at]);
            const int x = area.x + place % area.width, y = area.y + place / area.width;
            if (!sums.has(x, y))
                continue;
            const std::size_t pixel = sums.index(x, y);
            const glm::vec3 ambient = three(column_ambient, at), irradiance = three(column_irradiance, at);
            if (sums.has_lights())
                add_to(sums.lights, pixel, weight * three(column_direct, at));
            add_to(sums.picture.diffuse.exact, pixel, weight * ambient);
            add_to(sums.picture.specular.exact, pixel, weight * three(column_reflected, at));
            add_to(sums.picture.diffuse.albedo, pixel, weight * diffuse_albedo(ambient, irradiance));
            add_to(guides.normal, pixel, weight * three(column_shine, at));
            guides.coverage[pixel] += weight;
            guides.depth[pixel] += weight * f[column_depth][at];
            guides.alpha[pixel] += weight * f[column_alpha][at];
            guides.metalness[pixel] += weight * f[column_metallic][at];
        }
    }
}

// Adds the background to pixels that surfaces do not cover. Alpha remains the coverage by surfaces.
void TileDrawer::add_background(Frame& frame, const TileArea& area)
{
    const Background& background = picture_.settings.background;
    const bool lit =
        picture_.prepared.light.environment &&
        (background.kind == Background::Kind::environment || background.kind == Background::Kind::blurred);
    if (!lit && background.kind != Background::Kind::color)
        return;
    alignas(64) float row[3][largest_size];
    for (std::size_t channel = 0; channel < 3; ++channel)
        std::fill(std::begin(row[channel]), std::end(row[channel]),
                  background.color[static_cast<int>(channel)]);
    float* const rgb[3] = {row[0], row[1], row[2]};
    for (int y = 0; y < area.height; ++y) {
        const float* shares = background_.data() + y * area.width;
        if (std::all_of(shares, shares + area.width, [](float share) { return share <= 0.0f; }))
            continue;
        if (lit)
            light_background(picture_.prepared.light, picture_.prepared.rays,
                             {static_cast<float>(area.y + y) + 0.5f, area.x, area.width,
                              picture_.prepared.background_level},
                             rgb);
        for (int x = 0; x < area.width; ++x) {
            const glm::vec3 light = shares[x] * glm::vec3(row[0][x], row[1][x], row[2][x]);
            for (image::RadianceImage* image :
                 {&frame.radiance, picture_.settings.layers ? &frame.layers.back().image : nullptr})
                if (image)
                    for (int channel = 0; channel < 3; ++channel)
                        image->pixel(area.x + x, area.y + y)[channel] += light[channel];
        }
    }
}

} // namespace lambent::draw
