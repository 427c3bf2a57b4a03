// What a file's broken parts cost: warnings instead of errors.
#pragma once

#include "base/error.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace lambent::scene {

/// Adds lines to warnings. Lines that differ in their numbers only become one that counts them, and beyond `most_lines`
/// the others are only counted: a file of a million faults costs no memory.
class Losses {
public:
    /// `file` starts the line that counts the others.
    Losses(std::string file, Warnings& warnings) : file_(std::move(file)), warnings_(warnings) {}

    /// "FAULT: COST", or the fault alone. An empty fault was told before.
    void add(std::string_view fault, std::string_view cost = {});

    /// Does the work. Where it throws Error(bad_input), its line is added with the cost, and false returned.
    template <class Work>
    bool spare(std::string_view cost, Work&& work)
    {
        try {
            work();
            return true;
        } catch (const Error& error) {
            if (error.failure() != Failure::bad_input)
                throw;
            add(error.what(), cost);
            return false;
        }
    }

    static constexpr std::size_t most_lines = 24;

private:
    struct Line {
        std::size_t place; // in the warnings
        std::string first;
        std::size_t more = 0;
    };

    std::string file_;
    Warnings& warnings_;
    std::map<std::string, Line> lines_; // by what they say, without numbers
    Line others_{0, {}, 0};
};

/// Error(bad_input) about what a warning has told already: Losses adds nothing for it.
Error told_already();

} // namespace lambent::scene
