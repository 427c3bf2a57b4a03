// The 40-sample specular pass of the product against the yardstick, on the same surfaces, in one process.
#include "bench/side_by_side.h"
#include "bench/specular/yardstick.h"
#include "draw/cpu/specular_kernel.h"
#include "environment/environment.h"

#include <hwy/targets.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace {

using namespace lambent;

environment::Environment environment_of_formula(int width)
{
    image::RadianceImage image{width, width / 2, 3, {}};
    image.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(width / 2) * 3);
    const int height = width / 2;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double phi = ((x + 0.5) / width - 0.5) * 2 * std::numbers::pi;
            const double theta = (y + 0.5) / height * std::numbers::pi;
            const float d[3] = {static_cast<float>(std::sin(theta) * std::cos(phi)),
                                static_cast<float>(std::cos(theta)),
                                static_cast<float>(std::sin(theta) * std::sin(phi))};
            bench::yardstick_radiance(d, image.pixel(x, y));
        }
    return environment::make_environment(environment::make_panorama(image));
}

// The surfaces in pieces of a tile's size, as the renderer holds them.
std::vector<draw::Fragments> fragments_of(const std::vector<bench::YardstickSurface>& surfaces)
{
    constexpr std::size_t tile = 1024;
    std::vector<draw::Fragments> tiles((surfaces.size() + tile - 1) / tile);
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        draw::Fragments& f = tiles[t];
        f.resize(tile);
        for (std::size_t i = 0; i < tile; ++i) {
            const bench::YardstickSurface& s = surfaces[std::min(t * tile + i, surfaces.size() - 1)];
            for (int k = 0; k < 3; ++k) {
                f[draw::column_shine + k][i] = s.normal[k];
                f[draw::column_view + k][i] = s.view[k];
                f[draw::column_base_color + k][i] = s.specular[k];
                f[draw::column_specular + k][i] = s.specular[k];
                f[draw::column_shine + 3 + k][i] = 0.0f;
                f[draw::column_shine + 6 + k][i] = 0.0f;
            }
            f[draw::column_metallic][i] = s.specular[0] > 0.5f ? 1.0f : 0.0f;
            f[draw::column_exponent][i] = s.exponent;
            f[draw::column_alpha][i] = std::sqrt(2.0f / (s.exponent + 2.0f));
        }
    }
    return tiles;
}

void run(const char* name, std::int64_t target)
{
    if ((hwy::SupportedTargets() & target) == 0) {
        std::printf("%-8s not on this processor\n", name);
        return;
    }
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();
    static const bench::YardstickScene scene = bench::make_yardstick_scene();
    static const environment::Environment environment = environment_of_formula(2048);
    static const std::vector<bench::YardstickSurface> surfaces = bench::yardstick_surfaces(scene);
    const draw::SampleTables tables = draw::make_sample_tables(bench::yardstick_samples);
    std::vector<float> rgba(static_cast<std::size_t>(bench::yardstick_width) * bench::yardstick_height * 4);
    const auto yardstick = [&] {
        tbb::parallel_for(0, bench::yardstick_height, [&](int y) {
            bench::draw_yardstick_row(scene, y,
                                      rgba.data() + static_cast<std::size_t>(y) * bench::yardstick_width * 4);
        });
    };
    for (draw::Model model : {draw::Model::phong, draw::Model::ggx}) {
        std::vector<draw::Fragments> tiles = fragments_of(surfaces);
        draw::LightContext context;
        context.model = model;
        context.environment = &environment;
        context.tables = &tables;
        const auto ours = [&] {
            tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t t) {
                draw::light_specularly(context, 0, tiles[t].size(), tiles[t]);
            });
        };
        bench::side_by_side(std::string(name) + (model == draw::Model::phong ? ", phong" : ", ggx"), 11, ours,
                            yardstick);
    }
    hwy::SetSupportedTargetsForTest(0);
}

} // namespace

int main()
{
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
    std::printf(
        "40-sample specular pass, 1280x720, 60 %% covered, 2 threads, against the yardstick kernel\n");
    run("AVX-512", HWY_AVX3);
    run("AVX2", HWY_AVX2);
    run("SSE4", HWY_SSE4);
}
