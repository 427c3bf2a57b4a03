#include "kitchen/trace_kitchen.h"

#include "kitchen/smooth.h"
#include "environment/builtin/builtin.h"
#include "kitchen/model/kitchen.h"
#include "reference/tracer.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace lambent {
namespace {

constexpr double pi = std::numbers::pi;

// The environment outside the room, split in two panoramas whose sum it is.
struct Outside {
    image::RadianceImage sky, sun;
};

// The direction of a texel's centre, oriented as environment::Panorama.
glm::dvec3 direction_of(const image::RadianceImage& panorama, int x, int y)
{
    const double azimuth = ((x + 0.5) / panorama.width - 0.5) * 2.0 * pi;
    const double polar = (y + 0.5) / panorama.height * pi;
    return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

glm::dvec3 sun_direction()
{
    const double azimuth = static_cast<double>(kitchen::sun_azimuth);
    const double elevation = static_cast<double>(kitchen::sun_elevation);
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            std::cos(elevation) * std::cos(azimuth)};
}

Outside make_outside()
{
    Outside outside;
    outside.sky = environment::make_builtin(
        "sky", {1024, kitchen::sun_azimuth, kitchen::sun_elevation, kitchen::sky_turbidity});
    outside.sun = outside.sky;
    const glm::dvec3 sun = sun_direction();
    const double near = std::cos(1.2 * pi / 180.0);
    for (int y = 0; y < outside.sky.height; ++y)
        for (int x = 0; x < outside.sky.width; ++x) {
            const glm::dvec3 d = direction_of(outside.sky, x, y);
            const bool of_sun = glm::dot(d, sun) > near;
            for (int c = 0; c < 3; ++c) {
                if (of_sun)
                    outside.sky.pixel(x, y)[c] = 0.0f;
                if (!of_sun)
                    outside.sun.pixel(x, y)[c] = 0.0f;
            }
        }
    return outside;
}

reference::Settings settings_of(const KitchenTrace& trace)
{
    reference::Settings settings;
    settings.width = trace.width;
    settings.height = trace.height;
    settings.panorama_from = kitchen::kitchen_viewpoint();
    settings.bounces = trace.bounces;
    settings.samples = trace.samples;
    settings.noise = trace.noise;
    settings.seconds = 0.5 * trace.seconds;
    settings.adaptive = true;
    return settings;
}

image::RadianceImage without_alpha(const image::RadianceImage& image)
{
    image::RadianceImage rgb{image.width, image.height, 3, {}};
    for (std::size_t i = 0; i < image.values.size(); ++i)
        if (i % 4 != 3)
            rgb.values.push_back(image.values[i]);
    return rgb;
}

// Adds the light of sky and sun, in the units of the panorama. Noise is removed from each separately: the noise of the
// sky would hide the edges of the sun's patches.
image::RadianceImage combined(const scene::Scene& scene, const reference::Result& sky,
                              const reference::Result& sun, bool smooth)
{
    image::RadianceImage sum = without_alpha(sky.radiance), other = without_alpha(sun.radiance);
    if (smooth) {
        const std::vector<FirstHit> hits =
            first_hits(scene, {kitchen::kitchen_viewpoint(), sum.width, sum.height, 16});
        sum = smoothed(sum, sky.variance, hits);
        other = smoothed(other, sun.variance, hits);
    }
    for (std::size_t i = 0; i < sum.values.size(); ++i)
        sum.values[i] = kitchen::exposure * (sum.values[i] + other.values[i]);
    return sum;
}

// The noise that reference::Settings::noise limits; infinite where the time was too short to estimate it.
double noise_of(const reference::Result& result)
{
    return result.noise ? result.noise->covered : std::numeric_limits<double>::infinity();
}

} // namespace

KitchenPicture trace_kitchen(const KitchenTrace& trace, const std::function<void(double)>& report)
{
    const Outside outside = make_outside();
    scene::Scene scene = kitchen::make_kitchen();
    const reference::Settings settings = settings_of(trace);
    double before = 0.0;
    const auto go_on = [&](const reference::Progress& progress) {
        if (report)
            report(before + 0.5 * progress.done);
        return true;
    };
    const reference::Result sky = reference::trace(scene, &outside.sky, settings, go_on);
    before = 0.5;
    // The first picture contains the light of the lamps.
    for (scene::Material& material : scene.materials)
        material.emissive = glm::vec3(0.0f);
    const reference::Result sun = reference::trace(scene, &outside.sun, settings, go_on);
    return {combined(scene, sky, sun, trace.smooth), noise_of(sky), noise_of(sun), sky.samples, sun.samples};
}

} // namespace lambent
