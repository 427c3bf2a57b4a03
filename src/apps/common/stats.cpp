#include "apps/common/stats.h"

#include <nlohmann/json.hpp>

#include <cstdio>

#include <sys/resource.h>

namespace lambent::cli {

void add_cost(const Stopwatch& watch, nlohmann::ordered_json& stats)
{
    nlohmann::ordered_json& times = stats["times_ms"];
    for (const auto& [stage, ms] : watch.laps())
        times[stage] = ms;
    times["total"] = watch.total_ms();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    stats["peak_memory_mb"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void print(const nlohmann::ordered_json& object)
{
    // File names may hold any bytes; what is not UTF-8 is shown as a replacement character.
    std::puts(object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

} // namespace lambent::cli
