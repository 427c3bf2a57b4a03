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

} // namespace

TileDrawer::TileDrawer(const PictureContext& picture)
    : picture_(picture), sight_(picture.scene, picture.prepared.rays)
{
}

void TileDrawer::draw(const TileArea& area, Frame& frame)
{
    background_.assign(static_cast<std::size_t>(area.width * area.height), 0.0f);
    look_at_centres(area);
    choose_looks(area);
    for (int wave = 0; wave < most_waves && !looks_.empty(); ++wave) {
        build_fragments();
        shade();
        resolve(frame, area);
        look_behind();
    }
    for (const Look& look : looks_) // still transparent after the last wave
        background_[look.pixel] += look.weight;
    add_background(frame, area);
}

void TileDrawer::find_group(const Fragments::Group& group)
{
    SurfaceContext context = picture_.scene.surface(group.instance);
    context.rays = picture_.prepared.rays;
    context.model = picture_.settings.model;
    context.energy_compensation = picture_.settings.energy_compensation;
    context.roughness = picture_.settings.roughness_override;
    find_surfaces(context, group.begin, group.end, fragments_);
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
