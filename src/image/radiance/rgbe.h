// The RGBE pixel: three 8-bit mantissas with a shared exponent (Ward, "Real Pixels", Graphics Gems II, 1991).
//
// Mantissa m with exponent byte e stands for m 2^(e-136) if e > 0, and for 0 if e = 0. Radiance's own programs
// use m + 1/2 instead, because they truncate when writing; other libraries (OpenCV, OpenImageIO, stb_image, all
// after Walter's rgbe.c of 1995) use m. With m and rounding to nearest, 0 and 1 are exact, and a file that is
// read and written again keeps its codes. The two interpretations differ by less than 0.4 % of the largest
// channel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lambent::image {

using Rgbe = std::array<std::uint8_t, 4>;

/// Factor for each channel from stored values to radiance.
using ChannelScale = std::array<float, 3>;

/// Converts `count` pixels, stored as four consecutive planes of `count` bytes (R, G, B, exponent), to 3 * count
/// floats, which are exact if the scale is 1.
void planes_to_rgb(const std::uint8_t* planes, std::size_t count, const ChannelScale& scale, float* rgb);

/// The same for interleaved pixels.
void pixels_to_rgb(const Rgbe* pixels, std::size_t count, const ChannelScale& scale, float* rgb);

/// The nearest codes. The largest mantissa of a pixel is at least 128, by which decoders tell pixels from the
/// bytes that begin planes (2, 2) and repeats (1, 1, 1). Negative and NaN channels become 0; values of 2^127 and
/// more, infinity included, become the largest code; pixels below 2^-128 become black.
Rgbe to_rgbe(float red, float green, float blue);

} // namespace lambent::image
