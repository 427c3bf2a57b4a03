#include "apps/cli/commands.h"
#include "apps/cli/compare_table.h"
#include "apps/common/console.h"
#include "apps/common/input_files.h"
#include "apps/common/stats.h"
#include "apps/common/stopwatch.h"
#include "apps/common/threads.h"
#include "base/file.h"
#include "base/text.h"
#include "compare/difference.h"
#include "compare/flip.h"
#include "compare/heat_map.h"
#include "compare/image_pair.h"
#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace lambent::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Findings {
    compare::Difference difference;
    compare::ErrorMap flip_map;
    double flip = 0.0;
    std::optional<compare::Exposures> exposures; ///< of HDR-FLIP
};

void check_heat_file(const std::string& path)
{
    if (path.empty())
        return;
    const image::FileKind kind = image::file_kind(path);
    if (kind != image::FileKind::png && kind != image::FileKind::jpeg)
        throw Error(Failure::usage, text(path, ": a heat map's name ends in .png or .jpg"));
    check_can_write(path);
}

compare::ImagePair prepare(const CompareArguments& arguments, Warnings& warnings)
{
    compare::ImagePair pictures = compare::read_image_pair(arguments.picture, arguments.reference, warnings);
    if (arguments.covered)
        compare::keep_covered(arguments.picture, arguments.reference, pictures);
    if (arguments.exposure && pictures.kind == compare::Kind::srgb)
        throw Error(Failure::usage, "--exposure: only for linear light, .exr or .hdr");
    for (image::RadianceImage* picture : {&pictures.picture, &pictures.reference}) {
        if (arguments.exposure)
            compare::expose(*picture, *arguments.exposure);
        if (arguments.clamp)
            compare::clamp(*picture, *arguments.clamp);
    }
    return pictures;
}

// The peak signal of PSNR: the largest code; for light the bound of --clamp, else the reference's largest value.
double peak_of(const CompareArguments& arguments, const compare::ImagePair& pictures)
{
    if (pictures.kind == compare::Kind::srgb)
        return 1.0;
    return arguments.clamp ? static_cast<double>(*arguments.clamp)
                           : compare::largest_value(pictures.reference);
}

Findings find(const CompareArguments& arguments, const compare::ImagePair& pictures, Console& console)
{
    const compare::Pair pair{pictures.picture, pictures.reference, pictures.covered};
    const compare::FlipSettings settings{arguments.pixels_per_degree,
                                         [&](float done) { console.progress(done); }};
    Findings findings;
    findings.difference = compare::difference(pair, peak_of(arguments, pictures));
    if (pictures.kind == compare::Kind::srgb) {
        findings.flip_map = compare::ldr_flip(pair, settings);
    } else {
        compare::HdrFlip flip = compare::hdr_flip(pair, settings);
        findings.flip_map = std::move(flip.map);
        findings.exposures = flip.exposures;
    }
    console.end_progress();
    findings.flip = compare::mean(findings.flip_map, pair);
    return findings;
}

image::CodeImage draw_heat(Heat heat, const compare::ImagePair& pictures, const Findings& findings)
{
    const compare::Pair pair{pictures.picture, pictures.reference};
    if (heat == Heat::relative) {
        const compare::ErrorMap map = compare::relative_error(pair);
        return compare::heat_map(map, {"relative error", 1.0, compare::mean(map)});
    }
    if (heat == Heat::absolute) {
        const compare::ErrorMap map = compare::absolute_error(pair);
        return compare::heat_map(map, {"absolute error", compare::round_top(map), compare::mean(map)});
    }
    return compare::heat_map(findings.flip_map,
                             {findings.exposures ? "HDR-FLIP" : "LDR-FLIP", 1.0, findings.flip});
}

// JSON has no infinity.
Json finite(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json describe(const compare::ImagePair& pictures, const Findings& findings)
{
    Json json = {{"rmse", finite(findings.difference.rmse)},
                 {"relative_rmse", finite(findings.difference.relative_rmse)},
                 {"psnr", finite(findings.difference.psnr)},
                 {"flip", findings.flip},
                 {"max", finite(findings.difference.max)},
                 {"width", pictures.picture.width},
                 {"height", pictures.picture.height},
                 {"kind", compare::name_of(pictures.kind)}};
    if (!pictures.covered.empty())
        json["covered"] = compare::pixel_count({pictures.picture, pictures.reference, pictures.covered});
    if (findings.exposures)
        json["flip_exposures"] = {{"start", findings.exposures->start},
                                  {"stop", findings.exposures->stop},
                                  {"count", findings.exposures->count}};
    return json;
}

void check_bounds(const CompareArguments& arguments, const Findings& findings)
{
    std::string passed;
    const auto check = [&](const char* what, double value, const char* option, std::optional<double> bound) {
        if (bound && !(value <= *bound))
            passed += text(passed.empty() ? "" : "; ", what, " ", value, " is above ", option, " ", *bound);
    };
    check("FLIP", findings.flip, "--max-flip", arguments.max_flip);
    check("relative RMSE", findings.difference.relative_rmse, "--max-rel", arguments.max_relative);
    if (!passed.empty())
        throw Error(Failure::over_bound, text(arguments.picture, ": ", passed));
}

} // namespace

void run(const CompareArguments& arguments)
{
    check_heat_file(arguments.output);
    InputFiles({arguments.picture, arguments.reference}).keep_from(arguments.output);
    const ThreadLimit limit(arguments.common.threads);
    Console console(arguments.common.verbosity);
    Stopwatch watch;
    Warnings warnings;
    const compare::ImagePair pictures = prepare(arguments, warnings);
    console.warn_of_input(warnings, arguments.common);
    watch.lap("read");
    const Findings findings = find(arguments, pictures, console);
    watch.lap("compare");
    if (!arguments.output.empty()) {
        image::write_codes(draw_heat(arguments.heat, pictures, findings), arguments.output);
        console.remark(text("wrote ", arguments.output));
        watch.lap("write");
    }
    Json json = describe(pictures, findings);
    if (arguments.common.stats_json)
        add_cost(watch, json);
    if (arguments.json || arguments.common.stats_json || isatty(STDOUT_FILENO) == 0)
        print(json);
    else
        std::fputs(compare_table(json).c_str(), stdout);
    // A failure to print is reported before a bound that is exceeded.
    if (std::fflush(stdout) != 0)
        throw Error(Failure::cannot_write, "standard output: cannot write");
    check_bounds(arguments, findings);
}

} // namespace lambent::cli
