// The thread pool of the OpenEXR library, of which a process has one.
#pragma once

#include <cstdint>

namespace lambent::image {

/// Number of the library's threads to use for `pixels` pixels; the first call that needs them starts them. 0 if
/// waking them would take longer than they save. `bytes_each` is the memory that each thread takes.
int exr_threads(std::int64_t pixels, std::uint64_t bytes_each);

} // namespace lambent::image
