#include "apps/cli/bake_files.h"
#include "apps/cli/commands.h"
#include "apps/cli/console.h"
#include "apps/cli/stats.h"
#include "apps/cli/stopwatch.h"
#include "apps/cli/threads.h"
#include "base/error.h"
#include "base/text.h"
#include "environment/builtin.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace lambent::cli {
namespace {

environment::Panorama load_panorama(const std::string& name, Warnings& warnings)
{
    if (environment::is_builtin(name))
        return environment::make_panorama(environment::make_builtin(name));
    return environment::load_panorama(name, warnings);
}

Baked bake(const environment::Panorama& panorama, const BakeArguments& arguments, Console& console)
{
    Baked baked;
    baked.specular = environment::bake_specular(panorama, arguments.options, [&](double done) {
        console.progress(static_cast<float>(done), "specular light");
    });
    console.end_progress();
    baked.coefficients = environment::irradiance_coefficients(environment::project_to_harmonics(panorama));
    if (arguments.one_file)
        return baked;
    if (arguments.irradiance_size > 0)
        baked.irradiance = environment::bake_irradiance(panorama, arguments.irradiance_size);
    baked.table = environment::bake_split_sum_table(arguments.table_size);
    return baked;
}

nlohmann::ordered_json describe(const BakeArguments& arguments, const Baked& baked)
{
    nlohmann::ordered_json levels = nlohmann::ordered_json::array();
    double error = 0.0;
    for (std::size_t i = 0; i < baked.specular.levels.size(); ++i) {
        const environment::BakedLevel& level = baked.specular.levels[i];
        levels.push_back({{"size", baked.specular.cube.face_size(static_cast<int>(i))},
                          {"roughness", level.perceptual_roughness},
                          {"error", level.error}});
        error = std::max(error, level.error);
    }
    return {{"command", "bake"},
            {"environment", arguments.environment},
            {"output", arguments.output},
            {"size", arguments.options.size},
            {"error", error},
            {"levels", levels}};
}

void print_levels(const environment::BakedSpecular& specular)
{
    for (std::size_t i = 0; i < specular.levels.size(); ++i) {
        const environment::BakedLevel& level = specular.levels[i];
        const int size = specular.cube.face_size(static_cast<int>(i));
        std::printf("level %zu: %dx%d, roughness %.3f, error %.3f%%\n", i, size, size,
                    level.perceptual_roughness, 100.0 * level.error);
    }
}

// Where the error asked for was not reached, as on a panorama of one bright texel and a narrow lobe it may not be.
Warnings warnings_of(const BakeArguments& arguments, const environment::BakedSpecular& specular)
{
    Warnings warnings;
    for (std::size_t i = 0; i < specular.levels.size(); ++i)
        if (const double error = specular.levels[i].error; error > arguments.options.error)
            warnings.push_back(
                text("level ", i, ": the error is ", 100.0 * error, "%, above what was asked for"));
    return warnings;
}

} // namespace

void run(const BakeArguments& arguments)
{
    check_bake_output(arguments);
    const ThreadLimit limit(arguments.common.threads);
    Console console(arguments.common.verbosity);
    Stopwatch watch;
    Warnings warnings;
    const environment::Panorama panorama = load_panorama(arguments.environment, warnings);
    watch.lap("environment");
    console.warn(warnings);
    const Baked baked = bake(panorama, arguments, console);
    console.warn(warnings_of(arguments, baked.specular));
    watch.lap("bake");
    for (const std::string& name : write_baked(baked, arguments))
        console.remark(text("wrote ", name));
    watch.lap("write");
    if (arguments.common.stats_json) {
        nlohmann::ordered_json stats = describe(arguments, baked);
        add_cost(watch, stats);
        print(stats);
    } else if (arguments.common.verbosity != Verbosity::quiet) {
        print_levels(baked.specular);
    }
}

} // namespace lambent::cli
