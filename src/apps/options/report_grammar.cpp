#include "apps/options/report_grammar.h"

#include "apps/options/values.h"

namespace lambent::cli {

void ReportGrammar::add(Command& app)
{
    command_ = app.add_subcommand("report", "Draw the 2014 report's figures and more, as one page");
    command_.add_required("-o,--output", arguments_.output, "DIR",
                          "The folder: index.html, report.json and pictures");
    option(command_, "--env", arguments_.environment, "ENV",
           "A panorama (.hdr, .exr), or kitchen, studio, sky, furnace (kitchen)");
    option(command_, "--env-rotation", rotation_, "DEG", "Turn the environment about the vertical (0)");
    option(command_, "--size", size_, "WxH", "Size of a figure in pixels (512x288)");
    command_.add_flag("--quick", arguments_.quick, "No references, no errors");
    option(command_, "--noise", noise_, "REL", "References stop at this estimated relative error (0.02)");
    option(command_, "--spp", samples_, "N", "References stop at N samples per pixel (48)");
    command_.add_flag("--no-cache", no_cache_, "Neither read nor write the environment cache");
    option(command_, "--backend", backend_, "NAME", "auto or cpu (auto)");
    add_common(command_, common_);
}

ReportArguments ReportGrammar::result() const
{
    ReportArguments arguments = arguments_;
    arguments.common = common_options(common_);
    arguments.cache = !no_cache_;
    if (arguments.output.empty())
        throw Error(Failure::usage, "--output: nothing given");
    if (arguments.environment == "none")
        throw Error(Failure::usage, "--env: a report needs an environment");
    if (arguments.quick && !(noise_.empty() && samples_.empty()))
        throw Error(Failure::usage, "--quick makes no references: --noise and --spp say nothing then");
    if (!size_.empty()) {
        const Size size = parse_size(size_, "--size");
        if (size.width < 16 || size.height < 16 || size.width > 4096 || size.height > 4096)
            throw Error(Failure::usage, text("--size: ", size_, " is not from 16x16 to 4096x4096"));
        arguments.width = size.width;
        arguments.height = size.height;
    }
    if (!rotation_.empty())
        arguments.rotation = parse_number(rotation_, "--env-rotation");
    if (!noise_.empty())
        arguments.noise = static_cast<double>(number_in(noise_, "--noise", 1e-4, 1.0));
    if (!samples_.empty())
        arguments.samples = whole_in(samples_, "--spp", 1, 1 << 20);
    if (!backend_.empty())
        choose<bool>(backend_, "--backend", {{"auto", true}, {"cpu", true}});
    return arguments;
}

} // namespace lambent::cli
