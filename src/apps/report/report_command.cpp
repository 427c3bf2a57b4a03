#include "apps/report/report_command.h"

#include "apps/common/console.h"
#include "apps/common/interrupt.h"
#include "apps/common/new_folder.h"
#include "apps/common/stats.h"
#include "apps/common/stopwatch.h"
#include "apps/common/threads.h"
#include "base/version.h"
#include "apps/report/make_page.h"
#include "base/file.h"
#include "base/text.h"

#include <nlohmann/json.hpp>
#include <tbb/info.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent::cli {
namespace {

// Thrown when the user has interrupted the program.
struct Stopped {};

// The work of a page in seconds on two cores, by the renderer's estimates.
constexpr double seconds_of_a_quick_page = 8.0, seconds_of_a_page = 77.0;

report::ShotRendererSettings workshop_settings(const ReportArguments& arguments, const NewFolder& folder)
{
    report::ShotRendererSettings settings;
    settings.environment = arguments.environment;
    settings.size = {"--size", text(arguments.width, "x", arguments.height)};
    if (arguments.rotation != 0.0)
        settings.rotation = {"--env-rotation", text(arguments.rotation)};
    settings.cache = arguments.cache;
    settings.noise = arguments.noise;
    settings.samples = arguments.samples;
    settings.folder = folder.path("");
    return settings;
}

void add_facts(const ReportArguments& arguments, const Stopwatch& watch, report::Page& page)
{
    const auto label = [](const char* name) { return report::built_in_content().label(name); };
    const int threads =
        arguments.common.threads > 0 ? arguments.common.threads : tbb::info::default_concurrency();
    page.facts = {{label("program"), text("lambent ", version)},
                  {label("environment"), arguments.environment},
                  {label("size"), text(arguments.width, " x ", arguments.height)},
                  {label("threads"), text(threads)},
                  {label("time"), text(report::rounded(watch.total_ms() / 1000.0), " s")}};
}

void write_text(const std::string& content, const std::filesystem::path& path)
{
    write_file(path, {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()});
}

void print_stats(const ReportArguments& arguments, const report::ReportContext& context,
                 const Stopwatch& watch)
{
    // The largest noise is unknown without references, and where that of any reference is.
    constexpr double unknown = std::numeric_limits<double>::infinity();
    double noise = context.entries.empty() ? unknown : 0.0;
    for (const report::Entry& entry : context.entries)
        noise = std::max(noise, entry.comparison.noise.value_or(unknown));
    nlohmann::ordered_json stats = {{"command", "report"},
                                    {"environment", arguments.environment},
                                    {"output", arguments.output},
                                    {"backend", "cpu"},
                                    {"width", arguments.width},
                                    {"height", arguments.height},
                                    {"references", context.entries.size()},
                                    {"reference_noise", nullptr}};
    if (std::isfinite(noise))
        stats["reference_noise"] = noise;
    add_cost(watch, stats);
    print(stats);
}

void make_report(const ReportArguments& arguments, const Interrupt& interrupt, Console& console)
{
    const ThreadLimit limit(arguments.common.threads);
    Stopwatch watch;
    NewFolder folder(arguments.output);
    report::ShotRendererSettings settings = workshop_settings(arguments, folder);
    double seconds = 0.0;
    settings.progress = [&](double more) {
        if (interrupt.asked())
            throw Stopped();
        seconds += more;
        const double all = arguments.quick ? seconds_of_a_quick_page : seconds_of_a_page;
        console.progress(static_cast<float>(std::min(seconds / all, 0.99)));
    };
    report::ShotRenderer renderer(settings);
    report::ReportContext context{report::built_in_content(), renderer, !arguments.quick, {}};
    try {
        report::Page page = report::make_page(context);
        std::vector<std::string> files = renderer.finish();
        console.end_progress();
        console.warn_of_input(renderer.warnings(), arguments.common);
        watch.lap("draw");
        add_facts(arguments, watch, page);
        write_text(report::to_json(page), folder.path("report.json"));
        write_text(report::to_html(page), folder.path("index.html"));
        files.insert(files.end(), {"report.json", "index.html"});
        folder.put_in_place(files, InputFiles({arguments.environment}));
    } catch (const Error& error) {
        throw Error(error.failure(), folder.without_hiding(error.what()));
    }
    watch.lap("write");
    console.remark(text("wrote ", arguments.output, "/index.html"));
    if (arguments.common.stats_json)
        print_stats(arguments, context, watch);
}

} // namespace

void run(const ReportArguments& arguments)
{
    check_can_make_folder(arguments.output);
    const Interrupt interrupt;
    Console console(arguments.common.verbosity);
    try {
        make_report(arguments, interrupt, console);
    } catch (const Stopped&) {
        console.end_progress();
        interrupt.end_program();
    }
}

} // namespace lambent::cli
