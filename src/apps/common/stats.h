// Statistics as JSON.
#pragma once

#include "apps/common/stopwatch.h"

#include <nlohmann/json_fwd.hpp>

namespace lambent::cli {

/// Adds "times_ms" (each stage and "total") and "peak_memory_mb" of this process.
void add_cost(const Stopwatch& watch, nlohmann::ordered_json& stats);

/// Prints the object as one line on standard output.
void print(const nlohmann::ordered_json& object);

} // namespace lambent::cli
