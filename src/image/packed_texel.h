// Packs single texels into small floating-point formats. tests/image bounds the errors.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace lambent::image {

/// Added before the fraction is truncated, this rounds to nearest, halves up. It is the float just below 0.5: adding
/// 0.5 itself would also round up the float just below 0.5.
inline constexpr float round_half_up = 0x1.fffffep-2f;

/// Packs RGB into three 9-bit mantissas with a shared 5-bit exponent. Components are clamped to [0, 65408], NaN becomes
/// 0; the error is at most 2^-9 of the largest component (and 2^-25 absolute). [OpenGL 4.6, 8.5.2 "Encoding of Special
/// Internal Formats"]
inline std::uint32_t pack_rgb9e5(float r, float g, float b)
{
    const auto cut = [](float v) { return v > 0.0f ? std::min(v, 65408.0f) : 0.0f; };
    r = cut(r), g = cut(g), b = cut(b);
    const float largest = std::max(r, std::max(g, b));
    // floor(log2(largest)) from its bits, at least -16, which is stored as 0.
    int exponent = std::max(-16, static_cast<int>(std::bit_cast<std::uint32_t>(largest) >> 23) - 127);
    // 2^(8 - exponent): the largest component gets nine bits.
    float scale = std::bit_cast<float>(static_cast<std::uint32_t>(127 + 8 - exponent) << 23);
    if (largest * scale + 0.5f >= 512.0f) {
        ++exponent;
        scale *= 0.5f;
    }
    const auto mantissa = [scale](float v) { return static_cast<std::uint32_t>(v * scale + round_half_up); };
    return static_cast<std::uint32_t>(exponent + 16) << 27 | mantissa(b) << 18 | mantissa(g) << 9 |
           mantissa(r);
}

struct Rgb {
    float r = 0.0f, g = 0.0f, b = 0.0f;
};

inline Rgb unpack_rgb9e5(std::uint32_t texel)
{
    const float scale = std::bit_cast<float>(((texel >> 27) + 127 - 24) << 23);
    return {static_cast<float>(texel & 511) * scale, static_cast<float>(texel >> 9 & 511) * scale,
            static_cast<float>(texel >> 18 & 511) * scale};
}

/// The value as a half float, rounded to nearest even. Magnitudes above 65504 become 65504, NaN becomes 0.
inline std::uint16_t to_half(float value)
{
    const float magnitude = std::min(std::fabs(value), 65504.0f);
    if (!(magnitude >= 0.0f))
        return 0;
    const std::uint16_t sign = std::signbit(value) ? 0x8000 : 0;
    if (magnitude < 6.103515625e-05f) // subnormal: steps of 2^-24; adding 0.5 lets the adder round
        return static_cast<std::uint16_t>(sign | (std::bit_cast<std::uint32_t>(magnitude + 0.5f) & 0x7ff));
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(magnitude) - (112u << 23);
    return static_cast<std::uint16_t>(sign | (bits + 0xfff + (bits >> 13 & 1)) >> 13);
}

inline float from_half(std::uint16_t half)
{
    const std::uint32_t magnitude = half & 0x7fffu;
    const float value = magnitude < 0x400 ? static_cast<float>(magnitude) * 0x1p-24f
                                          : std::bit_cast<float>((magnitude << 13) + (112u << 23));
    return half & 0x8000 ? -value : value;
}

} // namespace lambent::image
