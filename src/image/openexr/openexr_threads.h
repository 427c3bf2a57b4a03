// The threads of the OpenEXR library, which are one pool for the process.
#pragma once

#include <cstdint>

namespace lambent::image {

/// How many of OpenEXR's threads to use for `pixels` pixels; starts them when first needed. 0 where waking
/// them costs more than it brings. `bytes_each` is the memory that each of them takes.
int exr_threads(std::int64_t pixels, std::uint64_t bytes_each);

} // namespace lambent::image
