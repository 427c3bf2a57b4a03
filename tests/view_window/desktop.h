// A screen that nobody sees, programs on it, and hands that move there.
#pragma once

#include "tests/support/process.h"

#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

namespace lambent::testing {

/// A program that runs until it ends or is ended.
class Running {
public:
    /// `words`: the program, found through PATH, and its arguments. What it says goes to `output`.
    Running(const std::vector<std::string>& words, const std::string& output);
    ~Running();
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    /// Waits until it ends; its exit code, 128 + n if a signal ended it, or -1 if it did not within the time, which, as
    /// all waits here, is multiplied by patience.
    int wait(double seconds);

    void signal(int number) const;

    /// Seconds of processor time that all its threads have used; 0 once it has ended.
    double busy_seconds() const;

private:
    pid_t process_ = -1;
};

/// A picture of the screen.
struct Screenshot {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;

    /// Of a part of it, over all channels.
    struct Area {
        int x, y, width, height;
    };
    double mean(const Area& area) const;
    /// The mean of absolute differences.
    double difference(const Screenshot& other, const Area& area) const;
    /// The share of pixels that are red enough to be meant.
    double redness(const Area& area) const;
};

class Desktop {
public:
    /// Null where Xvfb or xdotool is missing; `why` then says which. More words for Xvfb may be given.
    static std::unique_ptr<Desktop> open(std::string& why, const std::string& more = "");

    const std::string& display() const { return display_; }
    const Folder& folder() const { return folder_; }

    /// Calls xdotool; false if it failed.
    bool act(const std::vector<std::string>& words) const;

    /// At most so many rows from the top.
    Screenshot look(int rows = 65536) const;

    /// Looks until nothing has changed and the program has had nothing to do for a while, at most `seconds`.
    Screenshot look_at_rest(double seconds, const Running& program) const;

private:
    Folder folder_;
    std::string display_;
    std::unique_ptr<Running> server_;
};

} // namespace lambent::testing
