#include "draw/prepared_picture.h"

#include "draw/layer_list.h"
#include "equations/in_double.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace lambent::draw {
namespace {

// N positions in the unit square, no two in the same row or column. [Hammersley 1960]
std::vector<glm::vec2> subpixel_places(int count)
{
    std::vector<glm::vec2> places;
    places.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        places.emplace_back((static_cast<float>(i) + 0.5f) / static_cast<float>(count),
                            std::fmod(radical_inverse(static_cast<unsigned>(i)) + 0.5 / count, 1.0));
    return places;
}

std::array<int, 4> nearest_to_corners(const std::vector<glm::vec2>& places)
{
    std::array<int, 4> nearest{};
    for (int corner = 0; corner < 4; ++corner) {
        const auto away = [&](const glm::vec2& place) {
            return glm::distance(place, glm::vec2(corner % 2, corner / 2));
        };
        const auto found =
            std::min_element(places.begin(), places.end(),
                             [&](const glm::vec2& a, const glm::vec2& b) { return away(a) < away(b); });
        nearest[static_cast<std::size_t>(corner)] = static_cast<int>(found - places.begin());
    }
    return nearest;
}

// Normals that differ by 30 degrees between pixels are edges; looks within 15 degrees may share a shading point. With
// many samples accuracy counts: every look is shaded, because reflections in curved surfaces vary inside a pixel.
Edges edges_of(const Settings& settings)
{
    constexpr int many_samples = 256;
    const bool every_look = settings.samples >= many_samples;
    Edges edges;
    edges.places = subpixel_places(settings.edge_samples);
    edges.corners = nearest_to_corners(edges.places);
    edges.bend_cosine = every_look ? 0.995f : 0.866f;
    edges.shared_cosine = every_look ? 2.0f : 0.966f;
    edges.extent = 1.0f / std::sqrt(static_cast<float>(settings.edge_samples));
    return edges;
}

// The number of samples of small fragments: two fifths, but no fewer than a split-sum picture has. The report's own levels
// belong to its own number of samples.
int few_samples(const Settings& settings)
{
    if (settings.mip_level == MipLevel::report)
        return settings.samples;
    return std::min(settings.samples, std::max(split_sum_samples, settings.samples * 2 / 5));
}

LobePoints lobe_points(const Settings& settings)
{
    return settings.mip_level == MipLevel::report ? LobePoints::hammersley : LobePoints::spiral;
}

double level_of_background(const environment::Environment& environment, const Settings& settings,
                           const RayMap& rays)
{
    const double level_one = environment::level_one_deviation(environment.chain);
    // In a wide view of a large panorama a pixel covers many texels, which a blur level averages.
    const double pixel = glm::length(rays.direction_dx);
    const double texel = 6.283185307179586 / environment.panorama.width;
    const bool blurred = settings.background.kind == Background::Kind::blurred;
    if (!blurred && (settings.pipeline || pixel < 2.0 * texel))
        return -1.0;
    // A Gaussian of the lobe's width: seen along the normal, the reflected lobe of GGX is about 2 alpha wide.
    const double deviation = blurred ? std::pow(settings.background.roughness, 2) : 0.0;
    return in_double::level_of_variance((deviation * deviation + pixel * pixel / 12.0) /
                                        (level_one * level_one));
}

LightSource light_source(const scene::Light& light)
{
    LightSource source;
    source.local = light.kind != scene::LightKind::directional;
    source.position = light.position;
    source.intensity = light.intensity;
    source.axis = light.direction;
    source.range = light.range;
    if (light.kind == scene::LightKind::spot) {
        source.cos_inner = std::cos(light.inner_cone);
        source.cos_outer = std::cos(light.outer_cone);
    }
    return source;
}

ReportPowers powers_of(const ReportPipeline& pipeline)
{
    const float gamma = pipeline.linear ? 2.2f : 1.0f;
    return {gamma, pipeline.exposure, pipeline.contrast / gamma, 1.0f / gamma};
}

} // namespace

PreparedPicture::PreparedPicture(std::span<const scene::Light> scene_lights,
                                 const environment::Environment* environment, const Settings& given)
    : settings(given), rays(ray_map(given.camera, given.width, given.height)), edges(edges_of(given)),
      tables(make_sample_tables(given.samples, lobe_points(given))),
      few_tables(make_sample_tables(few_samples(given), lobe_points(given))),
      hit_tables(make_sample_tables(std::min(given.samples, split_sum_samples), lobe_points(given))),
      lights(light_sources(scene_lights, given.lights))
{
    if (environment && settings.model == Model::phong && settings.mip_level == MipLevel::report)
        mips = environment::mip_chain(environment->panorama);
    light.model = settings.model;
    light.mip_level = settings.mip_level;
    light.energy_compensation = settings.energy_compensation;
    light.ambient_brightness = settings.ambient_brightness;
    light.environment = environment;
    light.mip_chain = &mips;
    light.across = settings.camera.right;
    light.rotation_cosine = std::cos(settings.environment_rotation);
    light.rotation_sine = std::sin(settings.environment_rotation);
    light.tables = &tables;
    if (settings.pipeline)
        light.pipeline = powers_of(*settings.pipeline);
    light.middle_level = settings.layers;
    few_light = light;
    few_light.tables = &few_tables;
    hit_light = light;
    hit_light.tables = &hit_tables;
    hit_light.middle_level = false;
    if (environment)
        background_level = static_cast<float>(level_of_background(*environment, settings, rays));
}

std::vector<LightSource> light_sources(std::span<const scene::Light> lights,
                                       std::span<const scene::Light> more)
{
    std::vector<LightSource> sources;
    for (const scene::Light& light : lights)
        sources.push_back(light_source(light));
    for (const scene::Light& light : more)
        sources.push_back(light_source(light));
    return sources;
}

Frame blank_frame(const Settings& settings, const scene::Scene& scene)
{
    Frame frame;
    frame.radiance = image::black_image(settings.width, settings.height, 4);
    if (std::any_of(scene.materials.begin(), scene.materials.end(),
                    [](const scene::Material& material) { return material.unlit; }))
        frame.radiance.unlit = frame.radiance.values;
    if (!settings.layers)
        return frame;
    for (const LayerSource& source : layer_sources(settings.model))
        frame.layers.push_back(
            {source.name, source.kind, image::black_image(settings.width, settings.height, 4)});
    frame.layers.push_back(
        {background_layer, Layer::Kind::light, image::black_image(settings.width, settings.height, 4)});
    return frame;
}

} // namespace lambent::draw
