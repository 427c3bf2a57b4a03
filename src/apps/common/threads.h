// A limit on the number of threads.
#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>

namespace lambent::cli {

/// While it exists, TBB and all that uses it are limited to `count` threads; 0: one per processor.
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
