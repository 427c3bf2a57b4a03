#include "apps/options/grammar.h"

#include "apps/options/values.h"

namespace lambent::cli {

float number_in(const std::string& word, const std::string& option, double least, double most)
{
    const double value = parse_number(word, option);
    if (value < least || value > most)
        throw Error(Failure::usage, text(option, ": ", word, " is not from ", least, " to ", most));
    return static_cast<float>(value);
}

float positive(const std::string& word, const std::string& option)
{
    const float value = static_cast<float>(parse_number(word, option));
    if (!(value > 0.0f))
        throw Error(Failure::usage, text(option, ": ", word, " is not above 0"));
    return value;
}

int whole_in(const std::string& word, const std::string& option, int least, int most)
{
    const double value = parse_number(word, option);
    if (value < least || value > most || value != static_cast<double>(static_cast<int>(value)))
        throw Error(Failure::usage,
                    text(option, ": ", word, " is not a whole number from ", least, " to ", most));
    return static_cast<int>(value);
}

void option(Command& app, const std::string& name, std::string& word, const std::string& kind,
            const std::string& help)
{
    app.add_option(name, word, kind, help);
}

void add_common(const Command& command, CommonWords& words)
{
    Command app = command.under(everywhere);
    option(app, "--threads", words.threads, "N", "Worker threads (one per processor)");
    option(app, "--stats", words.stats, "json",
           "Print what was done and how long it took, as one JSON object");
    app.add_flag("--strict", words.strict, "A warning about an input file is an error, exit code 3");
    app.add_flag("--quiet", words.quiet, "No progress bar, no warnings");
    app.add_flag("--verbose", words.verbose, "Say what is being done");
}

Backend choose_backend(const std::string& word)
{
    return choose<Backend>(
        word, "--backend",
        {{"auto", Backend::automatic}, {"cpu", Backend::cpu}, {"vulkan", Backend::vulkan}});
}

CommonOptions common_options(const CommonWords& words)
{
    CommonOptions common;
    if (words.quiet && words.verbose)
        throw Error(Failure::usage, "--quiet and --verbose exclude each other");
    if (words.quiet)
        common.verbosity = Verbosity::quiet;
    if (words.verbose)
        common.verbosity = Verbosity::verbose;
    common.strict = words.strict;
    if (!words.threads.empty())
        common.threads = whole_in(words.threads, "--threads", 1, 1024);
    if (!words.stats.empty())
        common.stats_json = choose<bool>(words.stats, "--stats", {{"json", true}});
    return common;
}

} // namespace lambent::cli
