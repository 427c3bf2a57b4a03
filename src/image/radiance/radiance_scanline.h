// Scanlines of Radiance images in their three encodings ("Radiance File Formats"; Ward, LBNL).
//
//  - planes: bytes 2, 2, length high, length low; then R, G, B and exponent planes, each in packets: n > 128
//    means n - 128 times the next byte, 1 <= n <= 128 the next n bytes. Lengths 8 to 32767 only.
//  - pixels: 4 bytes each. A pixel 1, 1, 1, n repeats the previous pixel n times; if another such pixel
//    follows directly, it stands for n << 8 repeats, and so on.
//  - flat: the same without repeats, so that the bytes are the pixels.
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
    std::size_t bytes; ///< length in the file
};

/// Number of bytes that must be readable after the encoded bytes and writable after the decoded ones, because
/// they are copied in steps of 16.
inline constexpr std::size_t scanline_slack = 16;

/// Most bytes of a scanline of `length` pixels: each pixel followed by three repeat counts.
constexpr std::size_t max_scanline_bytes(int length)
{
    return static_cast<std::size_t>(length) * 16 + 4;
}

/// The scanline as error messages name it.
struct ScanlineId {
    const std::string& file;
    int index; ///< of the scanline, in file order
};

/// Checks the scanline at the start of `bytes` and finds its end. Returns nothing if the bytes end first.
/// Throws Error(bad_input) if it is no scanline of `length` pixels.
std::optional<Scanline> find_scanline(std::span<const std::uint8_t> bytes, int length, const ScanlineId& id);

/// Decodes a scanline that find_scanline found to be planes into R, G, B and exponent planes of `length` bytes
/// each; scanline_slack applies.
void decode_planes(const std::uint8_t* bytes, int length, std::uint8_t* planes);

/// Decodes a scanline that find_scanline found to be pixels into `length` pixels.
void decode_pixels(const std::uint8_t* bytes, int length, Rgbe* pixels);

/// Whether scanlines of `length` pixels can be stored as planes.
constexpr bool has_planes(int length)
{
    return length >= 8 && length <= 32767;
}

} // namespace lambent::image
