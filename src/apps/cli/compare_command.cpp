#include "apps/cli/commands.h"
#include "apps/cli/console.h"
#include "apps/cli/stats.h"
#include "apps/cli/threads.h"
#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "compare/codes.h"
#include "compare/flip.h"
#include "compare/heat_map.h"
#include "compare/metrics.h"
#include "image/image_io.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lambent::cli {
namespace {

// A picture as it is compared: light, or codes from 0 to 1.
struct Comparable {
    image::RadianceImage values;
    bool light = false;
};

Comparable load(const std::string& path, Warnings& warnings)
{
    const image::ImageInfo info = image::inspect(path);
    Comparable c;
    c.light = info.format == "Radiance HDR" || info.format == "OpenEXR";
    if (c.light) {
        c.values = image::read_radiance(path);
        if (const std::uint64_t broken = compare::mend_values(c.values))
            warnings.push_back(text(path, ": ", broken, " values are not finite and count as 0"));
        return c;
    }
    c.values = compare::code_values(image::read_codes(path));
    return c;
}

const char* kind_of(const Comparable& c)
{
    return c.light ? "linear light" : "display codes";
}

void check_alike(const CompareArguments& arguments, const Comparable& a, const Comparable& b)
{
    if (a.light != b.light)
        throw Error(Failure::bad_input,
                    text(arguments.image, " holds ", kind_of(a), " and ", arguments.reference, " ",
                         kind_of(b), ": they cannot be compared"));
    if (a.values.width != b.values.width || a.values.height != b.values.height)
        throw Error(Failure::bad_input, text(arguments.image, " is ", a.values.width, "x", a.values.height,
                                             " and ", arguments.reference, " ", b.values.width, "x",
                                             b.values.height, ": they cannot be compared"));
}

void prepare(const CompareArguments& arguments, Comparable& c)
{
    if (arguments.exposure != 1.0f) {
        if (!c.light)
            throw Error(Failure::usage, "--exposure: only for linear light (.exr, .hdr)");
        for (float& value : c.values.values)
            value *= arguments.exposure;
    }
    if (arguments.clamp)
        compare::clamp_values(c.values, *arguments.clamp);
}

compare::Plane flip_of(const Comparable& a, const Comparable& b)
{
    if (a.light)
        return compare::hdr_flip(a.values, b.values);
    return compare::flip(compare::light_of_codes(a.values), compare::light_of_codes(b.values));
}

void write_heat(const CompareArguments& arguments, const Comparable& a, const Comparable& b,
                const compare::Plane& flip)
{
    if (arguments.heat.empty())
        return;
    compare::Plane values = flip;
    compare::Legend legend{a.light ? "HDR-FLIP" : "FLIP", 1.0f, 0.0};
    if (arguments.heat_kind == HeatKind::relative) {
        values = compare::relative_difference(a.values, b.values);
        legend.title = "relative difference";
    } else if (arguments.heat_kind == HeatKind::absolute) {
        values = compare::absolute_difference(a.values, b.values);
        legend.title = "absolute difference";
        legend.most = std::max(*std::max_element(values.values.begin(), values.values.end()), 1e-20f);
    }
    legend.mean = compare::mean(values);
    image::write_codes(compare::heat_map(values, legend), arguments.heat);
}

// JSON knows no infinity.
nlohmann::ordered_json number(double value)
{
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

} // namespace

int run(const CompareArguments& arguments)
{
    if (!arguments.heat.empty()) {
        const image::FileKind kind = image::file_kind(arguments.heat);
        if (kind != image::FileKind::png && kind != image::FileKind::jpeg)
            throw Error(Failure::usage, text(arguments.heat, ": a heat map's name ends in .png or .jpg"));
        check_can_write(arguments.heat);
    }
    const ThreadLimit limit(arguments.common.threads);
    const Console console(arguments.common.verbosity);
    Warnings warnings;
    Comparable a = load(arguments.image, warnings), b = load(arguments.reference, warnings);
    console.warn(warnings);
    check_alike(arguments, a, b);
    prepare(arguments, a);
    prepare(arguments, b);
    const double peak = a.light ? static_cast<double>(compare::largest_value(b.values)) : 1.0;
    const compare::Metrics metrics = compare::measure(a.values, b.values, peak);
    const compare::Plane flip = flip_of(a, b);
    const double mean_flip = compare::mean(flip);
    write_heat(arguments, a, b, flip);
    print({{"rmse", number(metrics.rmse)},
           {"relative_rmse", number(metrics.relative_rmse)},
           {"psnr", number(metrics.psnr)},
           {"flip", number(mean_flip)},
           {"max", number(metrics.max)},
           {"kind", a.light ? "light" : "codes"},
           {"width", a.values.width},
           {"height", a.values.height}});
    if (arguments.max_flip && mean_flip > *arguments.max_flip)
        return console.over_bound("FLIP", mean_flip, *arguments.max_flip);
    if (arguments.max_relative && !(metrics.relative_rmse <= *arguments.max_relative))
        return console.over_bound("relative RMSE", metrics.relative_rmse, *arguments.max_relative);
    return 0;
}

} // namespace lambent::cli
