// The simplest valid PNG: one stored (uncompressed) zlib block, no filters.
#pragma once

#include <cstdint>
#include <vector>

namespace lambent::scene::test {

struct Pixels {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    int bits = 8;                      ///< 8 or 16
    std::vector<std::uint16_t> values; ///< RGBA
};

/// Below 64 KiB of pixels.
std::vector<std::uint8_t> make_png(const Pixels& pixels);

} // namespace lambent::scene::test
