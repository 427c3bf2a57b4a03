#include "bench/errors/error_cases.h"

#include "apps/options/arguments.h"
#include "apps/common/picture_setup.h"
#include "base/text.h"
#include "draw/cpu/cpu_renderer.h"
#include "environment/builtin/builtin.h"
#include "environment/environment.h"
#include "reference/tracer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent::bench {
namespace {

constexpr float unlimited = std::numeric_limits<float>::infinity();

// As the command line understands it: the same defaults, the same camera.
cli::RenderArguments arguments_of(const ErrorCase& c, int width)
{
    const std::string size = text(width, "x", width * 9 / 16);
    const std::vector<const char*> words = {
        "lambent", "render",     c.scene.c_str(), "--env",         c.environment.c_str(),
        "--size",  size.c_str(), "--model",       c.model.c_str(), "--bounces",
        "0",       "-o",         "x.exr"};
    return std::get<cli::RenderArguments>(cli::parse_arguments(static_cast<int>(words.size()), words.data()));
}

image::RadianceImage load(const std::string& name)
{
    Warnings warnings;
    return environment::is_builtin(name) ? environment::make_builtin(name)
                                         : environment::load_unpacked_panorama(name, warnings);
}

struct References {
    image::RadianceImage first, second;

    ReferencePair pair() const { return {&first, &second}; }
};

// The instance whose middle is nearest to the line of sight, where surfaces cover a part of the pixel: for a chart of
// spheres, the sphere. Other scenes are one region.
Regions regions_of(const scene::Scene& scene, const view::Picture& picture, const References& traced,
                   bool chart)
{
    const view::RayMap rays = view::ray_map(picture.camera, picture.width, picture.height);
    Regions regions;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            int region = std::max(traced.first.pixel(x, y)[3], traced.second.pixel(x, y)[3]) > 0.0f ? 0 : -1;
            if (chart && region == 0) {
                const glm::vec3 d =
                    glm::normalize(rays.direction + (static_cast<float>(x) + 0.5f) * rays.direction_dx +
                                   (static_cast<float>(y) + 0.5f) * rays.direction_dy);
                float nearest = unlimited;
                for (std::size_t i = 0; i < scene.instances.size(); ++i) {
                    const glm::vec3 to = glm::vec3(scene.instances[i].transform[3]) - rays.origin;
                    const float off = glm::length(glm::cross(to, d));
                    if (off < nearest) {
                        nearest = off;
                        region = static_cast<int>(i);
                    }
                }
            }
            regions.push_back(region);
        }
    return regions;
}

References trace_twice(const scene::Scene& scene, const image::RadianceImage& environment,
                       reference::Settings settings, int bounces)
{
    settings.bounces = bounces;
    settings.seconds /= 2.0;
    References two;
    two.first = reference::trace(scene, &environment, settings).radiance;
    settings.seed = 1;
    two.second = reference::trace(scene, &environment, settings).radiance;
    return two;
}

} // namespace

CaseErrors measure(const ErrorCase& c, int width, double seconds)
{
    const cli::RenderArguments arguments = arguments_of(c, width);
    Warnings warnings;
    const scene::Scene scene = cli::load_scene(arguments, warnings);
    draw::Settings settings = arguments.settings;
    settings.camera = cli::choose_camera(arguments, scene);
    const image::RadianceImage raw = load(c.environment);
    const environment::Environment environment =
        environment::make_environment(environment::make_panorama(raw));
    const auto renderer = draw::make_cpu_renderer(scene);
    const image::RadianceImage at_40 = renderer->draw(&environment, settings).radiance;
    settings.samples = 1024;
    const image::RadianceImage at_1024 = renderer->draw(&environment, settings).radiance;

    reference::Settings how;
    static_cast<view::Picture&>(how) = settings;
    how.seconds = seconds;
    const References direct = trace_twice(scene, raw, how, 0), full = trace_twice(scene, raw, how, 8);
    const bool chart = c.scene == "grid" || c.scene == "furnace";
    const Regions regions = regions_of(scene, settings, direct, chart);
    return {region_error(at_40, direct.pair(), regions, 1.0f),
            region_error(at_1024, direct.pair(), regions, 1.0f),
            region_error(at_40, direct.pair(), regions, unlimited),
            region_error(at_1024, direct.pair(), regions, unlimited),
            region_error(at_40, full.pair(), regions, 1.0f)};
}

} // namespace lambent::bench
