// What the grammars of all commands are made of.
#pragma once

#include "apps/options/arguments.h"
#include "apps/options/command_line.h"
#include "base/closest.h"
#include "base/error.h"
#include "base/text.h"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace lambent::cli {

/// The words of the options that every command has. The parsing fills them, and an empty one was not given.
struct CommonWords {
    std::string threads, stats;
    bool quiet = false, verbose = false, strict = false;
};

/// The value that goes with a word. Throws Error(usage) with the words that would do.
template <class Value>
Value choose(const std::string& word, const std::string& option,
             std::initializer_list<std::pair<const char*, Value>> choices)
{
    std::string known;
    for (const auto& [name, value] : choices) {
        if (word == name)
            return value;
        known += text(known.empty() ? "" : ", ", name);
    }
    std::vector<std::string> names;
    for (const auto& [name, value] : choices)
        names.emplace_back(name);
    throw Error(Failure::usage, text(option, ": '", word, "' is none of ", known, did_you_mean(word, names)));
}

/// "auto", "cpu" or "vulkan". Throws Error(usage).
Backend choose_backend(const std::string& word);

/// A number from `least` to `most`. Throws Error(usage).
float number_in(const std::string& word, const std::string& option, double least, double most);

/// A number above 0. Throws Error(usage).
float positive(const std::string& word, const std::string& option);

/// A whole number from `least` to `most`. Throws Error(usage).
int whole_in(const std::string& word, const std::string& option, int least, int most);

/// Adds an option with one word, of which the last counts. The help names its `kind`.
void option(Command& app, const std::string& name, std::string& word, const std::string& kind,
            const std::string& help);

/// Adds --threads, --stats, --strict, --quiet and --verbose.
void add_common(const Command& command, CommonWords& words);

/// What they say. Throws Error(usage).
CommonOptions common_options(const CommonWords& words);

} // namespace lambent::cli
