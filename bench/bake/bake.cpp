// What a bake of a 256-texel cube costs, from a panorama of 2048x1024 with a sun of radiance 50000: against the sum over
// all texels, in one process, and as a command, against `cmgen` where that is installed.
//   bench_bake [PANORAMA.hdr ...]
#include "bench/side_by_side.h"
#include "environment/bake/bake.h"
#include "environment/bake/texel_sums.h"
#include "environment/bake/bake_check.h"
#include "environment/bake/prefilter.h"
#include "image/files/image_io.h"
#include "tests/support/process.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace lambent;

image::RadianceImage sunny(int width)
{
    const double sun[3] = {0.5, 0.6, 0.6244998};
    image::RadianceImage image{width, width / 2, 3, {}};
    image.values.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(width / 2));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < width; ++x) {
            const double theta = (y + 0.5) / image.height * std::numbers::pi;
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
            const double d[3] = {std::sin(theta) * std::cos(phi), std::cos(theta),
                                 std::sin(theta) * std::sin(phi)};
            const bool in_sun = d[0] * sun[0] + d[1] * sun[1] + d[2] * sun[2] > std::cos(0.00465);
            for (int k = 0; k < 3; ++k)
                image.pixel(x, y)[k] = static_cast<float>(in_sun ? 50000.0 : 0.6 + 0.4 * d[1] + 0.1 * k);
        }
    return image;
}

void against_all_texels(const environment::Panorama& panorama)
{
    std::vector<environment::TexelSum> sums;
    for (int i = 0; i < 64; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / 64.0, phi = 2.4 * i, ring = std::sqrt(1.0 - y * y);
        sums.push_back({ring * std::cos(phi), y, ring * std::sin(phi), environment::ggx_lobe(0.25), {}});
    }
    environment::BakedSpecular baked;
    const bench::Comparison c = bench::side_by_side(
        "the cube, against 64 sums over all texels", 7,
        [&] { baked = environment::bake_specular(panorama, {}); },
        [&] { environment::sum_texels(panorama, sums); });
    const double rough = static_cast<double>(baked.cube.values.size() - baked.cube.level_start(1)) / 3.0;
    std::printf("  so %.0f times faster than a sum for each of %.0f texels, in double\n",
                rough / 64.0 / c.ratio, rough);
}

// Texels of a level: anywhere, or within 15 degrees of its brightest.
std::vector<environment::CubeTexel> places(const image::CubeMap& cube, int level, bool near,
                                           std::size_t count)
{
    const int size = cube.face_size(level);
    environment::CubeTexel brightest{0, 0, 0, size};
    std::vector<environment::CubeTexel> all;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                all.push_back({face, x, y, size});
                if (cube.pixel(level, face, x, y)[1] >
                    cube.pixel(level, brightest.face, brightest.x, brightest.y)[1])
                    brightest = all.back();
            }
    const environment::Direction to = texel_direction(brightest);
    if (near)
        std::erase_if(all, [&](const environment::CubeTexel& place) {
            const environment::Direction d = texel_direction(place);
            return d.x * to.x + d.y * to.y + d.z * to.z < 0.9659258;
        });
    std::mt19937 random(1);
    std::shuffle(all.begin(), all.end(), random);
    all.resize(std::min(all.size(), count));
    return all;
}

double error_of(const environment::Panorama& panorama, const environment::BakedSpecular& baked, int level,
                bool near)
{
    const double roughness = baked.levels[static_cast<std::size_t>(level)].perceptual_roughness;
    const std::vector<environment::CubeTexel> at = places(baked.cube, level, near, near ? 100 : 300);
    std::vector<environment::TexelSum> sums;
    for (const environment::CubeTexel& place : at) {
        const environment::Direction d = texel_direction(place);
        sums.push_back({d.x, d.y, d.z, environment::ggx_lobe(roughness * roughness), {}});
    }
    environment::sum_texels(panorama, sums);
    double square = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const double found =
                static_cast<double>(baked.cube.pixel(level, at[i].face, at[i].x, at[i].y)[k]);
            square += (found - sums[i].rgb[k]) * (found - sums[i].rgb[k]);
            mean += sums[i].rgb[k];
        }
    const double count = 3.0 * static_cast<double>(at.size());
    return std::sqrt(square / count) / (mean / count);
}

// At 300 texels anywhere, and 100 within 15 degrees of the brightest.
void print_errors(const std::string& name)
{
    Warnings warnings;
    const environment::Panorama panorama = environment::load_panorama(name, warnings);
    const environment::BakedSpecular baked = environment::bake_specular(panorama, {});
    std::printf("%s, errors in %% by roughness:", name.c_str());
    for (int level = 1; level < baked.cube.levels; ++level)
        std::printf(" %.3f: %.2f/%.2f", baked.levels[static_cast<std::size_t>(level)].perceptual_roughness,
                    100.0 * error_of(panorama, baked, level, false),
                    100.0 * error_of(panorama, baked, level, true));
    std::puts("");
}

double median_of(const std::string& program, const std::vector<std::string>& words)
{
    std::vector<double> seconds;
    for (int i = 0; i < 7; ++i) {
        const testing::Outcome outcome = testing::run_program(program, words);
        if (outcome.code != 0)
            return 0.0;
        seconds.push_back(outcome.seconds);
    }
    return bench::median(seconds);
}

void as_a_command(const std::string& panorama, const testing::Folder& folder)
{
    const double ours =
        median_of(LAMBENT_PROGRAM, {"bake", panorama, "-o", folder.path("o.ktx2"), "--quiet"});
    std::printf("%s: lambent bake %.3f s", panorama.c_str(), ours);
    const double rival = median_of(
        "cmgen", {"--quiet", "--size=256", "--format=ktx", "--ibl-ld=" + folder.path("cmgen"), panorama});
    if (rival > 0.0)
        std::printf("; cmgen %.3f s, ratio %.3f", rival, ours / rival);
    std::puts("");
}

} // namespace

int main(int count, char** words)
{
    const testing::Folder folder;
    std::vector<std::string> panoramas(words + 1, words + count);
    const image::RadianceImage image = sunny(2048);
    if (panoramas.empty()) {
        panoramas.push_back(folder.path("sun.hdr"));
        image::write_radiance(image, panoramas[0]);
    }
    against_all_texels(environment::make_panorama(image));
    for (const std::string& panorama : panoramas)
        as_a_command(panorama, folder);
    for (const std::string& panorama : panoramas)
        print_errors(panorama);
}
