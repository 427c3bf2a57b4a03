// Warnings about broken parts of a file, which are left out.
#pragma once

#include "base/error.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace lambent::scene {

/// Adds lines to warnings. Lines that differ only in their numbers become one line with a count, and beyond
/// `most_lines` others are only counted, so that a file with a million faults takes little memory.
class Losses {
public:
    /// `file` is the start of the line that counts the others.
    Losses(std::string file, Warnings& warnings) : file_(std::move(file)), warnings_(warnings) {}

    /// Adds "FAULT: COST", or the fault alone. Nothing for an empty fault, which was reported before.
    void add(std::string_view fault, std::string_view cost = {});

    /// Calls work(). If that throws Error(bad_input), adds the error's line with the cost, and returns false.
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
        std::size_t place; // index into the warnings
        std::string first;
        std::size_t more = 0;
    };

    std::string file_;
    Warnings& warnings_;
    std::map<std::string, Line> lines_; // by their text without numbers
    Line others_{0, {}, 0};
};

/// An Error(bad_input) about a fault that was reported before: Losses adds nothing for it.
Error told_already();

} // namespace lambent::scene
