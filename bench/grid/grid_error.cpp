// How far the drawn `grid` is from the integral of the environment's light, sphere by sphere:
//   bench_grid_error [--cache FOLDER] [--samples N]... [ENVIRONMENT...]
// An environment is a built-in's name or a panorama's path; none: studio and sky. Truths are kept in FOLDER.
#include "bench/grid/grid_truth.h"
#include "draw/cpu/cpu_renderer.h"
#include "environment/builtin/builtin.h"
#include "environment/environment.h"
#include "scene/builtin/builtin.h"

#include <glm/common.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace lambent;
using bench::TruePixel;

environment::Panorama load(const std::string& name)
{
    if (environment::is_builtin(name))
        return environment::make_panorama(environment::make_builtin(name));
    Warnings warnings;
    return environment::load_panorama(name, warnings);
}

std::vector<TruePixel> truths_of(const std::string& name, const std::string& cache, const scene::Scene& scene,
                                 const environment::Panorama& panorama, const bench::TruthPlan& plan)
{
    const std::string path = cache + "/" + std::filesystem::path(name).filename().string() + ".truth";
    const auto count = scene.instances.size() * static_cast<std::size_t>(plan.pixels_per_sphere);
    std::vector<TruePixel> pixels(count);
    const auto bytes = static_cast<std::streamsize>(count * sizeof(TruePixel));
    if (!cache.empty()) {
        std::ifstream file(path, std::ios::binary);
        if (file.read(reinterpret_cast<char*>(pixels.data()), bytes))
            return pixels;
    }
    pixels = bench::true_pixels(scene, panorama, plan);
    if (!cache.empty())
        std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(pixels.data()), bytes);
    return pixels;
}

// Over one sphere's pixels and channels.
struct Sum {
    double square = 0.0, mean = 0.0, bias = 0.0;
    int count = 0;

    void add(glm::dvec3 drawn, glm::dvec3 truth)
    {
        for (int k = 0; k < 3; ++k) {
            square += (drawn[k] - truth[k]) * (drawn[k] - truth[k]);
            bias += drawn[k] - truth[k];
            mean += truth[k];
            ++count;
        }
    }
    double relative() const { return std::sqrt(square / count) / std::max(mean / count, 1e-12); }
    double relative_bias() const { return bias / std::max(mean, 1e-12); }
};

glm::dvec3 pixel_of(const image::RadianceImage& image, int x, int y)
{
    const float* p = image.pixel(x, y);
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

glm::dvec3 clamped(glm::dvec3 c)
{
    return glm::clamp(c, 0.0, 1.0);
}

void print_table(const char* what, const std::vector<Sum>& sums, double (Sum::*figure)() const)
{
    std::printf("  %s; rows: metalness 0 to 1, columns: roughness 0 to 1\n", what);
    double mean = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double value = (sums[i].*figure)();
        mean += value / static_cast<double>(sums.size());
        std::printf("%8.2f%s", value * 100.0, i % 7 == 6 ? "\n" : "");
    }
    std::printf("  mean %.2f %%\n", mean * 100.0);
}

void compare(const image::RadianceImage& picture, const std::vector<TruePixel>& truths, int samples,
             bool full)
{
    std::vector<Sum> clipped(49), whole(49);
    for (const TruePixel& t : truths) {
        const glm::dvec3 drawn = pixel_of(picture, t.x, t.y), truth = t.specular + t.diffuse;
        clipped[static_cast<std::size_t>(t.sphere)].add(clamped(drawn), clamped(truth));
        whole[static_cast<std::size_t>(t.sphere)].add(drawn, truth);
    }
    const auto mean = [](const std::vector<Sum>& sums) {
        double total = 0.0;
        for (const Sum& s : sums)
            total += s.relative() / static_cast<double>(sums.size());
        return 100.0 * total;
    };
    std::printf("  %4d samples: relative RMSE, mean of 49 spheres: %.2f %% clamped, %.2f %% unclamped\n",
                samples, mean(clipped), mean(whole));
    if (!full)
        return;
    print_table("clamped, %", clipped, &Sum::relative);
    print_table("unclamped, %", whole, &Sum::relative);
    print_table("bias of the mean, unclamped, %", whole, &Sum::relative_bias);
}

void dump(const image::RadianceImage& picture, const std::vector<TruePixel>& truths, int sphere)
{
    for (const TruePixel& t : truths)
        if (t.sphere == sphere) {
            const glm::dvec3 d = pixel_of(picture, t.x, t.y), b = t.specular + t.diffuse;
            std::printf("    (%d, %d) drawn %.4f %.4f %.4f true %.4f %.4f %.4f diffuse %.4f\n", t.x, t.y, d.x,
                        d.y, d.z, b.x, b.y, b.z, t.diffuse.x);
        }
}

} // namespace

int main(int count, char** words)
{
    std::vector<std::string> names;
    std::vector<int> samples;
    std::string cache;
    bool full = true;
    int dumped = -1;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--cache" && i + 1 < count)
            cache = words[++i];
        else if (word == "--samples" && i + 1 < count)
            samples.push_back(std::stoi(words[++i]));
        else if (word == "--dump" && i + 1 < count)
            dumped = std::stoi(words[++i]);
        else if (word == "--brief")
            full = false;
        else
            names.push_back(word);
    }
    if (names.empty())
        names = {"studio", "sky"};
    if (samples.empty())
        samples = {40, 1024};
    const scene::Scene scene = scene::make_builtin("grid");
    bench::TruthPlan plan;
    plan.camera = draw::orbit_camera(scene::bounds(scene), {}, 0.7853982f,
                                     static_cast<float>(plan.width) / static_cast<float>(plan.height));
    const auto renderer = draw::make_cpu_renderer(scene);
    for (const std::string& name : names) {
        environment::Panorama panorama = load(name);
        const std::vector<TruePixel> truths = truths_of(name, cache, scene, panorama, plan);
        const environment::Environment environment = environment::make_environment(std::move(panorama));
        std::printf("%s\n", name.c_str());
        for (int n : samples) {
            draw::Settings settings;
            settings.camera = plan.camera;
            settings.samples = n;
            const draw::Frame frame = renderer->draw(&environment, settings);
            compare(frame.radiance, truths, n, full);
            if (dumped >= 0)
                dump(frame.radiance, truths, dumped);
        }
        std::fflush(stdout);
    }
}
