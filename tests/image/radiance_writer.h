// Radiance pictures made by hand, independently of the library's reader and writer.
#pragma once

#include "tests/image/bytes.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace lambent::test {

using Pixel = std::array<std::uint8_t, 4>; ///< R, G, B mantissa and exponent
using Pixels = std::vector<Pixel>;

/// The three encodings of one scanline.
Bytes flat_scanline(const Pixels& pixels);
Bytes repeat_scanline(const Pixels& pixels); ///< old: 1, 1, 1, n for n more of the pixel before
Bytes plane_scanline(const Pixels& pixels);  ///< new: planes of packets

/// "#?RADIANCE", FORMAT, `lines` (each with its newline), an empty line, and the resolution line.
Bytes radiance_header(const std::string& resolution, const std::string& lines = "");

/// What mantissa and exponent stand for, by the C library's ldexp.
std::array<float, 3> radiance_of(const Pixel& pixel);

/// Pixels with runs, noise and black in them, the same for the same seed. Each has a mantissa of 128 or
/// more, as encoders make them, or is 0.
Pixels mixed_pixels(std::size_t count, unsigned seed);

} // namespace lambent::test
