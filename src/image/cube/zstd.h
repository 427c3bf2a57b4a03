// Zstandard, where the build found it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lambent::image {

/// One frame that says its size. Throws Error(usage) where the build has no libzstd.
std::vector<std::uint8_t> compress_zstd(std::span<const std::uint8_t> bytes);

} // namespace lambent::image
