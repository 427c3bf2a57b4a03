#include "apps/common/bake_files.h"
#include "apps/cli/commands.h"
#include "apps/common/console.h"
#include "apps/common/input_names.h"
#include "apps/common/interrupt.h"
#include "apps/common/make_filler.h"
#include "apps/common/stats.h"
#include "apps/common/stopwatch.h"
#include "apps/common/threads.h"
#include "base/error.h"
#include "base/text.h"
#include "environment/builtin/builtin.h"
#include "environment/bake/split_sum.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lambent::cli {
namespace {

// Thrown when the user has asked to stop.
struct Stopped {};

// Rotates the panorama by whole columns, so that its texels are not resampled.
void turn(environment::Panorama& panorama, double degrees)
{
    const int width = panorama.width;
    const int columns = static_cast<int>(std::lround(degrees / 360.0 * width));
    const int shift = (columns % width + width) % width;
    for (auto row = panorama.texels.begin(); row != panorama.texels.end(); row += width)
        std::rotate(row, row + shift, row + width);
}

environment::Panorama load(const BakeArguments& arguments, Warnings& warnings)
{
    const std::string& name = arguments.environment;
    check_environment_name(name);
    environment::Panorama panorama = environment::is_builtin(name)
                                         ? environment::make_panorama(environment::make_builtin(name))
                                         : environment::load_panorama(name, warnings);
    turn(panorama, arguments.rotation);
    return panorama;
}

// Coefficients that are only rounding errors of the sum are set to 0.
std::vector<double> coefficients_of(const environment::Panorama& panorama)
{
    std::vector<double> c = environment::irradiance_coefficients(environment::project_to_harmonics(panorama));
    for (std::size_t i = 3; i < c.size(); ++i)
        if (std::fabs(c[i]) < 1e-9 * c[i % 3])
            c[i] = 0.0;
    return c;
}

Baked bake(const environment::Panorama& panorama, const BakeArguments& arguments, const Filler& filler,
           const std::function<void(double)>& report)
{
    Baked baked{environment::bake_specular(panorama, arguments.options, report, filler.fill),
                coefficients_of(panorama),
                {},
                {}};
    report(1.0);
    if (arguments.one_file)
        return baked;
    const int irradiance_size = arguments.irradiance_size.value_or(BakeArguments::usual_irradiance_size);
    if (irradiance_size > 0)
        baked.irradiance = environment::bake_irradiance(panorama, irradiance_size, filler.fill);
    baked.table =
        environment::bake_split_sum_table(arguments.table_size.value_or(BakeArguments::usual_table_size));
    return baked;
}

Warnings warnings_of(const BakeArguments& arguments, const Baked& baked)
{
    const environment::BakedSpecular& specular = baked.specular;
    Warnings warnings;
    if (const CutLight cut = cut_light(baked, arguments); cut.texels > 0)
        warnings.push_back(
            text(cut.texels, " texels are brighter than ", cut.most,
                 ", the maximum of their format, and are cut to it; --texels float keeps them"));
    if (arguments.one_file && arguments.irradiance_size.value_or(0) > 0)
        warnings.push_back(
            "--irradiance: a single file holds only the coefficients; -o FOLDER writes the cube too");
    if (arguments.one_file && arguments.table_size)
        warnings.push_back("--lut: a single file holds no split-sum table; -o FOLDER writes it");
    for (std::size_t i = 0; i < specular.levels.size(); ++i)
        if (const double error = specular.levels[i].error; error > arguments.options.error)
            warnings.push_back(text("level ", i, ": its error is ", std::round(1e4 * error) / 100.0,
                                    " %, above the target of ", 100.0 * arguments.options.error, " %"));
    return warnings;
}

nlohmann::ordered_json describe(const BakeArguments& arguments, const Baked& baked,
                                const std::vector<std::string>& files)
{
    nlohmann::ordered_json stats = {{"command", "bake"},
                                    {"environment", arguments.environment},
                                    {"output", arguments.output},
                                    {"files", files},
                                    {"size", arguments.options.size},
                                    {"levels", describe_levels(baked.specular)}};
    stats["irradiance"]["coefficients"] = baked.coefficients;
    stats["irradiance"]["size"] = baked.irradiance ? nlohmann::ordered_json(baked.irradiance->size) : nullptr;
    double error = 0.0;
    for (const nlohmann::ordered_json& level : stats["levels"])
        error = std::max(error, level["error"].get<double>());
    stats["error"] = error;
    return stats;
}

void print_levels(const environment::BakedSpecular& specular)
{
    for (std::size_t i = 0; i < specular.levels.size(); ++i) {
        const int size = specular.cube.face_size(static_cast<int>(i));
        std::printf("level %zu: %dx%d, roughness %.4f, error %.3f %%\n", i, size, size,
                    specular.levels[i].perceptual_roughness, 100.0 * specular.levels[i].error);
    }
}

void bake_to_files(const BakeArguments& arguments, const Interrupt& interrupt, Console& console)
{
    const auto stop_if_asked = [&] {
        if (interrupt.asked())
            throw Stopped();
    };
    const ThreadLimit limit(arguments.common.threads);
    const Filler filler = make_filler(arguments, [&](const std::string& line) { console.warn({line}); });
    Stopwatch watch;
    Warnings warnings;
    const environment::Panorama panorama = load(arguments, warnings);
    watch.lap("environment");
    console.warn_of_input(warnings, arguments.common);
    const Baked baked = bake(panorama, arguments, filler, [&](double done) {
        stop_if_asked();
        console.progress(static_cast<float>(done));
    });
    console.end_progress();
    console.warn(warnings_of(arguments, baked));
    watch.lap("bake");
    const std::vector<std::string> files = write_baked(baked, arguments, stop_if_asked);
    watch.lap("write");
    for (const std::string& file : files)
        console.remark(text("wrote ", file));
    if (arguments.common.stats_json) {
        nlohmann::ordered_json stats = describe(arguments, baked, files);
        const bool given_up = filler.given_up && *filler.given_up;
        stats["backend"] = given_up ? "cpu" : filler.backend;
        if (const std::optional<double> milliseconds = filler.milliseconds(); milliseconds && !given_up) {
            stats["device"] = filler.device;
            stats["device_ms"]["prefilter"] = *milliseconds;
        }
        add_cost(watch, stats);
        print(stats);
    } else if (arguments.common.verbosity != Verbosity::quiet) {
        print_levels(baked.specular);
    }
}

} // namespace

void run(const BakeArguments& arguments)
{
    check_bake_output(arguments);
    const Interrupt interrupt;
    Console console(arguments.common.verbosity);
    try {
        bake_to_files(arguments, interrupt, console);
    } catch (const Stopped&) {
        console.end_progress();
        interrupt.end_program();
    }
}

} // namespace lambent::cli
