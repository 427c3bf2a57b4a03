// Zstandard compression, if the build found libzstd.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lambent::image {

/// A Zstandard frame whose header holds the uncompressed size. Throws Error(usage) if the build has no libzstd.
std::vector<std::uint8_t> compress_zstd(std::span<const std::uint8_t> bytes);

} // namespace lambent::image
