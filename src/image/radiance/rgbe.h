// The RGBE pixel: three 8-bit mantissas and one shared exponent (Ward, "Real Pixels", Graphics Gems II,
// 1991).
//
// The value of mantissa m with exponent byte e is m 2^(e-136) for e > 0 and 0 for e = 0. Radiance's own
// programs take (m + 1/2) instead, because they truncate when they write; files of other makers, and the
// viewers people compare with (OpenCV, OpenImageIO, stb_image, all after Walter's rgbe.c of 1995), take m.
// With m and rounding to the nearest, black stays black, 1 stays 1, and a file read and written again has
// the same codes. The two readings differ by less than 0.4 % of the largest channel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lambent::image {

using Rgbe = std::array<std::uint8_t, 4>;

/// Radiance of each channel for a stored value of one.
using ChannelScale = std::array<float, 3>;

/// `count` pixels given as four planes, one behind the other, each `count` bytes: R, G, B, exponent. Writes
/// 3 * count floats, exact where the scale is 1.
void planes_to_rgb(const std::uint8_t* planes, std::size_t count, const ChannelScale& scale, float* rgb);

/// The same from interleaved pixels.
void pixels_to_rgb(const Rgbe* pixels, std::size_t count, const ChannelScale& scale, float* rgb);

/// The nearest codes. The largest mantissa of a pixel is at least 128 (what run length coding relies on),
/// so that planes and runs are told apart. Negative and NaN channels become 0; values of 2^127 and more,
/// infinity included, the largest code; pixels below 2^-128 black.
Rgbe to_rgbe(float red, float green, float blue);

} // namespace lambent::image
