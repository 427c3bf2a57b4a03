// Parallel loops over independent work.
#pragma once

#include <tbb/parallel_for.h>

#include <cstddef>
#include <exception>
#include <vector>

namespace lambent::scene {

/// Calls work(0) .. work(count - 1), each once, in parallel and in any order. If several throw, the exception of the
/// lowest index is rethrown, so that the same file always gives the same message.
template <class Work>
void parallel_for_each_index(std::size_t count, const Work& work)
{
    std::vector<std::exception_ptr> failures(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        try {
            work(i);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& failure : failures)
        if (failure)
            std::rethrow_exception(failure);
}

} // namespace lambent::scene
