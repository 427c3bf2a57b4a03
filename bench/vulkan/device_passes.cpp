// The passes on a Vulkan device by its own clock, and the whole drawing beside the processor's.
#include "bench/side_by_side.h"
#include "bench/vulkan/shading_flops.h"
#include "base/error.h"
#include "draw/cpu/cpu_renderer.h"
#include "draw/vulkan/device_prefilter.h"
#include "draw/vulkan/vulkan_renderer.h"
#include "environment/bake/bake.h"
#include "environment/builtin/builtin.h"
#include "scene/builtin/builtin.h"

#include <glm/geometric.hpp>

#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace lambent;

constexpr double mega = 1e6, giga = 1e9;

environment::Environment kitchen()
{
    return environment::make_environment(
        environment::make_panorama(environment::make_builtin("kitchen", {})));
}

draw::Settings settings_for(const scene::Scene& scene, int width, int height)
{
    draw::Settings settings;
    settings.width = width;
    settings.height = height;
    settings.camera = draw::orbit_camera(scene::bounds(scene), {0.0f, 0.0f, 0.0f}, 0.7854f, 16.0f / 9.0f);
    return settings;
}

// The fewest bytes that a pass moves: per pixel, and per pixel with a surface. Texels that are read again and again
// from caches are not counted, nor are the triangles.
struct Traffic {
    double pixel, surface;
};

const std::map<std::string, Traffic> traffic = {
    {"triangles", {5 * (8 + 4), 0}},       // five looks: instance and triangle, depth
    {"edges", {8 + 32 + 16, 32}},          // the middle look, what it saw, spans; records
    {"surfaces", {0, 32 + 42 * 4}},        // records, all columns
    {"direct", {0, (22 + 3) * 4}},         // position, view, normal, footprint, material; light
    {"ambient", {0, (3 + 3 + 5 + 6) * 4}}, // normal, view, material; irradiance and light
    {"specular", {0, (3 + 3 + 6 + 5 + 3) * 4}},
    {"resolve", {16 + 16, 32 + 13 * 4}}, // spans, picture; records, four lights
    {"background", {16 + 2 * 16 + 4 * 4, 0}},
    {"readback", {2 * 16, 0}}};

double covered(const image::RadianceImage& image)
{
    double sum = 0.0;
    for (std::size_t i = 3; i < image.values.size(); i += 4)
        sum += static_cast<double>(image.values[i]);
    return sum;
}

// Lamps of the environment, which are few, left out.
void print_specular(double samples, double fragments, double seconds)
{
    const bench::SpecularFlops flops = bench::count_specular_flops();
    std::printf("   %.0f million samples/s, %.1f Gflop/s (%.0f a sample)", samples / mega / seconds,
                (samples * flops.sample + fragments * flops.fragment) / giga / seconds, flops.sample);
}

// Medians of each pass over several pictures.
void print_passes(draw::Renderer& renderer, const environment::Environment& environment,
                  const draw::Settings& settings)
{
    constexpr int rounds = 9;
    std::map<std::string, std::vector<double>> times;
    draw::Frame frame = renderer.draw(&environment, settings); // compiles
    for (int round = 0; round < rounds; ++round) {
        frame = renderer.draw(&environment, settings);
        for (const auto& [name, milliseconds] : frame.passes)
            times[name].push_back(milliseconds);
    }
    const double pixels = static_cast<double>(settings.width) * settings.height,
                 surfaces = covered(frame.radiance);
    std::printf("grid, %dx%d, %d samples, %.0f %% covered\n", settings.width, settings.height,
                settings.samples, 100.0 * surfaces / pixels);
    std::printf("%-12s %10s %10s\n", "pass", "ms", "GB/s");
    double all = 0.0;
    for (const auto& pass : frame.passes) {
        const double ms = bench::median(times[pass.first]);
        const Traffic& t = traffic.at(pass.first);
        all += ms;
        std::printf("%-12s %10.3f %10.1f", pass.first.c_str(), ms,
                    (t.pixel * pixels + t.surface * surfaces) / giga / (ms * 1e-3));
        if (pass.first == "specular")
            print_specular(surfaces * settings.samples, surfaces, ms * 1e-3);
        std::printf("\n");
    }
    std::printf("%-12s %10.3f\n\n", "all", all);
}

// Lights of short range all over the scene: each point is reached by few.
std::vector<scene::Light> lights_over(const scene::Bounds& box, int count)
{
    std::vector<scene::Light> lights;
    const glm::vec3 size = box.high - box.low;
    for (int i = 0; i < count; ++i) {
        const auto fraction = [&](int step) {
            return static_cast<float>(i * step % count) / static_cast<float>(count);
        };
        scene::Light light;
        light.position = box.low + glm::vec3(fraction(7), fraction(13), fraction(31)) * size;
        light.range = 0.05f * glm::length(size);
        light.intensity = glm::vec3(0.001f);
        lights.push_back(light);
    }
    return lights;
}

void compare_lights(draw::Renderer& renderer, const scene::Scene& scene)
{
    draw::Settings few = settings_for(scene, 1280, 720), many = few;
    few.lights = lights_over(scene::bounds(scene), 10);
    many.lights = lights_over(scene::bounds(scene), 1000);
    bench::side_by_side(
        renderer.device().backend + ", 1000 lights against 10", 7, [&] { renderer.draw(nullptr, many); },
        [&] { renderer.draw(nullptr, few); });
}

// A cube of 256 texels: what the device takes for its levels, and the whole bake beside the processors'.
void compare_bakes()
{
    draw::DevicePrefilter device({});
    const environment::Panorama panorama =
        environment::make_panorama(environment::make_builtin("kitchen", {}));
    bench::side_by_side(
        "bake of a 256 cube", 7,
        [&] {
            environment::bake_specular(
                panorama, {}, {}, [&](const auto& faces, const auto& report) { device.fill(faces, report); });
        },
        [&] { environment::bake_specular(panorama, {}); });
    std::printf("  of it on the device: %.3f ms\n", bench::median(device.milliseconds()));
}

void run()
{
    const scene::Scene grid = scene::make_builtin("grid");
    const std::unique_ptr<draw::VulkanRenderer> device = draw::make_vulkan_renderer(grid);
    const std::unique_ptr<draw::Renderer> cpu = draw::make_cpu_renderer(grid);
    const environment::Environment environment = kitchen();
    std::printf("%s\n", device->device().description.c_str());
    print_passes(*device, environment, settings_for(grid, 1920, 1080));
    const draw::Settings settings = settings_for(grid, 1280, 720);
    bench::side_by_side(
        "grid, 1280x720, from settings to picture", 7, [&] { device->draw(&environment, settings); },
        [&] { cpu->draw(&environment, settings); });
    compare_lights(*device, grid);
    compare_lights(*cpu, grid);
    compare_bakes();
}

} // namespace

int main()
{
    try {
        run();
    } catch (const Error& error) {
        std::printf("skipped: %s\n", error.what());
    }
}
