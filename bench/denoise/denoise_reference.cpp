// The statistical filter against none, in one run: the error of the same samples with and without it, and its time against
// that of the samples. The truth is traced too, so this takes minutes: of three pictures, or of nine with as many samples
// of the truth as the argument says.
#include "apps/common/denoise_reference.h"
#include "apps/common/picture_setup.h"
#include "apps/common/reference_setup.h"
#include "apps/options/arguments.h"
#include "bench/side_by_side.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace {

using namespace lambent;

// A picture that is traced with some samples.
struct Shot {
    cli::ReferenceArguments arguments;
    scene::Scene scene;
    std::optional<image::RadianceImage> environment;
};

Shot shot_of(const char* scene, const char* environment)
{
    const char* const words[] = {"lambent", "reference", scene,       "--env", environment,
                                 "--size",  "480x270",   "--denoise", "-o",    "picture.exr"};
    Shot shot{std::get<cli::ReferenceArguments>(cli::parse_arguments(std::size(words), words)), {}, {}};
    Warnings warnings;
    shot.scene = cli::load_scene(shot.arguments.picture, warnings, nullptr);
    shot.environment = cli::load_raw_environment(environment, warnings);
    return shot;
}

reference::Result traced(const Shot& shot, int samples, std::uint32_t seed)
{
    cli::ReferenceArguments asked = shot.arguments;
    asked.samples = samples;
    asked.seed = seed;
    return reference::trace(shot.scene, shot.environment ? &*shot.environment : nullptr,
                            cli::reference_settings(asked, shot.scene));
}

// Relative root mean square error of light cut at 1, over pixels that surfaces cover, less the noise of the truth.
double error_of(const image::RadianceImage& picture, const reference::Result& traced_truth)
{
    const image::RadianceImage& truth = traced_truth.radiance;
    const double noise = traced_truth.noise ? traced_truth.noise->covered : 0.0;
    double squares = 0.0, sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < truth.values.size(); i += 4)
        for (std::size_t c = 0; c < 3 && truth.values[i + 3] > 0.0f; ++c) {
            const double light = std::min(static_cast<double>(truth.values[i + c]), 1.0),
                         found = std::min(static_cast<double>(picture.values[i + c]), 1.0);
            squares += (found - light) * (found - light);
            sum += light;
            count += 1.0;
        }
    return std::sqrt(std::max(squares * count / (sum * sum) - noise * noise, 0.0));
}

void compare(const char* scene, const char* environment, int truth_samples)
{
    const Shot shot = shot_of(scene, environment);
    const reference::Result truth = traced(shot, truth_samples, 77);
    for (const int samples : {1, 2, 4, 16, 64}) {
        reference::Result result;
        const double tracing = bench::seconds([&] { result = traced(shot, samples, 0); });
        image::RadianceImage filtered;
        const double filtering = bench::seconds([&] { filtered = cli::denoised(result); });
        const double before = error_of(result.radiance, truth), after = error_of(filtered, truth);
        std::printf(
            "%-8s %-8s %3d samples  error %.4f  filtered %.4f  ratio %.3f  time of filter / samples %.3f\n",
            scene, environment, samples, before, after, after / before, filtering / tracing);
        std::fflush(stdout);
    }
}

} // namespace

int main(int count, const char** words)
{
    if (count < 2) {
        compare("report", "kitchen", 256);
        compare("teapot", "studio", 256);
        compare("grid", "sky", 256);
        return 0;
    }
    for (const char* scene : {"report", "teapot", "grid"})
        for (const char* environment : {"kitchen", "studio", "sky"})
            compare(scene, environment, std::atoi(words[1]));
    return 0;
}
