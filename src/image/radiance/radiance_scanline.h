// One scanline of a Radiance picture, in any of its three encodings ("Radiance File Formats"; Ward, LBNL).
//
//  - planes: bytes 2, 2, length high, length low; then R, G, B and exponent planes, each in packets: n > 128
//    means n - 128 times the next byte, 1 <= n <= 128 the next n bytes. Lengths 8 to 32767 only.
//  - pixels: 4 bytes each. A pixel 1, 1, 1, n repeats the one before it n times; the next such pixel directly
//    behind it counts n << 8, and so on.
//  - flat: the same without any repeat, so that the bytes are the pixels.
#pragma once

#include "image/radiance/rgbe.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace lambent::image {

enum class ScanlineKind : std::uint8_t { planes, pixels, flat };

struct Scanline {
    ScanlineKind kind;
    std::size_t bytes; ///< in the file
};

/// Readable bytes there must be behind the encoded bytes, and writable ones behind the decoded: copies are
/// made in steps of 16.
inline constexpr std::size_t scanline_slack = 16;

/// Bytes that no scanline of that many pixels exceeds: each pixel with three repeat counts behind it.
constexpr std::size_t max_scanline_bytes(int length)
{
    return static_cast<std::size_t>(length) * 16 + 4;
}

/// What a refusal names.
struct ScanlinePlace {
    const std::string& file;
    int index; ///< of the scanline, in file order
};

/// Checks the scanline at the start of `bytes` and finds where it ends. Nothing when the bytes end first.
/// Throws Error(bad_input) when it is not one of `length` pixels.
std::optional<Scanline> find_scanline(std::span<const std::uint8_t> bytes, int length,
                                      const ScanlinePlace& place);

/// Turns a scanline that find_scanline accepted as planes into R, G, B and exponent planes, 4 * length bytes
/// and slack.
void decode_planes(const std::uint8_t* bytes, int length, std::uint8_t* planes);

/// Turns a scanline that find_scanline accepted as pixels into `length` pixels.
void decode_pixels(const std::uint8_t* bytes, int length, Rgbe* pixels);

/// Whether scanlines of that length can be written as planes.
constexpr bool has_planes(int length)
{
    return length >= 8 && length <= 32767;
}

} // namespace lambent::image
