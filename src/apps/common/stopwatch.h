// Wall-clock time by stage.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace lambent::cli {

class Stopwatch {
public:
    /// Ends the stage that has been running since the last lap and records it under a name.
    void lap(const std::string& stage)
    {
        const Clock::time_point now = Clock::now();
        laps_.emplace_back(stage, std::chrono::duration<double, std::milli>(now - last_).count());
        last_ = now;
    }

    /// Stages and their milliseconds, in order.
    const std::vector<std::pair<std::string, double>>& laps() const { return laps_; }

    double total_ms() const { return std::chrono::duration<double, std::milli>(last_ - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now(), last_ = start_;
    std::vector<std::pair<std::string, double>> laps_;
};

} // namespace lambent::cli
