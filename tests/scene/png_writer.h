// RGBA pictures as PNG files, for textures.
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

/// The bytes of the file, not compressed.
std::vector<std::uint8_t> make_png(const Pixels& pixels);

} // namespace lambent::scene::test
