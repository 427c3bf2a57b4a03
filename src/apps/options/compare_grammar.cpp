#include "apps/options/compare_grammar.h"

#include "apps/options/values.h"

namespace lambent::cli {
namespace {

double bound(const std::string& word, const std::string& option)
{
    const double value = parse_number(word, option);
    if (value < 0.0)
        throw Error(Failure::usage, text(option, ": ", word, " is below 0"));
    return value;
}

} // namespace

void CompareGrammar::add(Command& app)
{
    command_ = app.add_subcommand("compare", "Say how far a picture is from another");
    command_.add_required("image", arguments_.picture, "IMAGE", "A .png, .jpg, .exr or .hdr");
    command_.add_required("reference", arguments_.reference, "REFERENCE",
                          "What it should be: of the same size and kind");
    option(command_, "-o,--output", arguments_.output, "FILE",
           "A map of the error with a legend: .png or .jpg");
    option(command_, "--heat", heat_, "ERROR", "What it shows: flip, relative or absolute (flip)");
    option(command_, "--exposure", exposure_, "E", "Factor on both, linear light only (1)");
    option(command_, "--clamp", clamp_, "X", "Cut both to [0, X], after the exposure");
    option(command_, "--ppd", pixels_per_degree_, "P",
           "FLIP: pixels in a degree of the view, 1 to 1000 (67)");
    option(command_, "--max-flip", max_flip_, "X", "Exit with 1 if the mean FLIP error is above X");
    option(command_, "--max-rel", max_relative_, "X", "Exit with 1 if the relative RMSE is above X");
    command_.add_flag("--json", arguments_.json, "One JSON object, on a terminal too");
    add_common(command_, common_);
}

CompareArguments CompareGrammar::result() const
{
    CompareArguments arguments = arguments_;
    arguments.common = common_options(common_);
    if (!heat_.empty() && arguments.output.empty())
        throw Error(Failure::usage, "--heat: only with -o");
    if (!heat_.empty())
        arguments.heat =
            choose<Heat>(heat_, "--heat",
                         {{"flip", Heat::flip}, {"relative", Heat::relative}, {"absolute", Heat::absolute}});
    if (!exposure_.empty())
        arguments.exposure = positive(exposure_, "--exposure");
    if (!clamp_.empty())
        arguments.clamp = positive(clamp_, "--clamp");
    if (!pixels_per_degree_.empty())
        arguments.pixels_per_degree =
            static_cast<double>(number_in(pixels_per_degree_, "--ppd", 1.0, 1000.0));
    if (!max_flip_.empty())
        arguments.max_flip = bound(max_flip_, "--max-flip");
    if (!max_relative_.empty())
        arguments.max_relative = bound(max_relative_, "--max-rel");
    return arguments;
}

} // namespace lambent::cli
