#include "reference/traced_scene.h"

#include <cmath>

namespace lambent::reference {
namespace {

// The picture's points and lines as triangles. Panoramas show none, because their pixels differ in width.
std::optional<view::WidenedScene> lines_of(const scene::Scene& scene, const Settings& settings)
{
    if (!scene::has_lines(scene) || settings.panorama_from)
        return std::nullopt;
    view::WidenedScene lines(scene, view::WidenedScene::Others::left_out);
    lines.face(settings);
    return lines;
}

} // namespace

TracedScene::TracedScene(const scene::Scene& scene, const image::RadianceImage* panorama,
                         const Settings& settings)
    : visibility_(scene), lines_(lines_of(scene, settings)),
      surfaces_(scene, settings.model, settings.texel_transfer, settings.roughness_override,
                lines_ ? &lines_->scene() : nullptr),
      emitters_(scene)
{
    if (lines_)
        world_.lines = &seen_lines_.emplace(lines_->scene());
    if (panorama)
        environment_.emplace(*panorama, settings.environment_rotation);
    world_.visibility = &visibility_;
    world_.surfaces = &surfaces_;
    world_.environment = environment_ ? &*environment_ : nullptr;
    world_.emitters = emitters_.empty() ? nullptr : &emitters_;
    world_.lights = scene.lights;
    world_.lights.insert(world_.lights.end(), settings.lights.begin(), settings.lights.end());
    for (const scene::Material& material : scene.materials)
        world_.has_unlit = world_.has_unlit || material.unlit;
    world_.model = settings.model;
    world_.energy_compensation = settings.energy_compensation;
    world_.background = settings.background;
    world_.bounces = settings.bounces;
    world_.strategy = settings.strategy;
}

Lens lens_of(const Settings& settings)
{
    return settings.panorama_from ? Lens(*settings.panorama_from, settings.width, settings.height)
                                  : Lens(settings.camera, settings.width, settings.height);
}

Sight sample_pixel(const World& world, const Lens& lens, const SeededPixel& pixel, int number,
                   FirstSurface* first)
{
    const std::uint32_t sequence =
        hashed(hashed(static_cast<std::uint32_t>(pixel.x), pixel.seed), static_cast<std::uint32_t>(pixel.y));
    SampleSequence sampler(hashed(sequence, static_cast<std::uint32_t>(number % replicates)),
                           static_cast<std::uint32_t>(number / replicates));
    const std::array<double, 4> place = sampler.next4();
    return trace_path(world, lens.through(pixel.x + place[0], pixel.y + place[1]), sampler, first);
}

bool mend(Sight& sight)
{
    if (std::isfinite(sight.radiance.x + sight.radiance.y + sight.radiance.z))
        return true;
    sight.radiance = glm::dvec3(0.0);
    return false;
}

} // namespace lambent::reference
