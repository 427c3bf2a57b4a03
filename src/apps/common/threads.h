// How many threads the work is spread over.
#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>

namespace lambent::cli {

/// Limits TBB, and all that uses it, to `count` threads while it exists; 0: one per processor.
class ThreadLimit {
public:
    explicit ThreadLimit(int count)
        : limit_(tbb::global_control::max_allowed_parallelism,
                 static_cast<std::size_t>(count > 0 ? count : tbb::info::default_concurrency()))
    {
    }

private:
    tbb::global_control limit_;
};

} // namespace lambent::cli
