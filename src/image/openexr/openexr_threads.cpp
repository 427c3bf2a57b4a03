#include "image/openexr/openexr_threads.h"

#include <ImfThreading.h>

#include <algorithm>
#include <mutex>
#include <thread>

namespace lambent::image {
namespace {

// With more than eight threads, reading and copying limit the speed, and the buffers take more memory.
constexpr std::uint64_t most_threads = 8;
constexpr std::uint64_t most_memory = std::uint64_t{1} << 25;
constexpr std::int64_t worth_waking = std::int64_t{1} << 16;

std::uint64_t available_threads()
{
    return std::min<std::uint64_t>(most_threads, std::thread::hardware_concurrency());
}

} // namespace

int exr_threads(std::int64_t pixels, std::uint64_t bytes_each)
{
    const std::uint64_t wanted =
        std::min(available_threads(), most_memory / std::max<std::uint64_t>(bytes_each, 1));
    if (pixels < worth_waking || wanted < 2)
        return 0;
    static std::once_flag started;
    std::call_once(started, [] {
        if (Imf::globalThreadCount() == 0)
            Imf::setGlobalThreadCount(static_cast<int>(available_threads()));
    });
    return static_cast<int>(wanted);
}

} // namespace lambent::image
