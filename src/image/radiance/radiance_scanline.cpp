#include "image/radiance/radiance_scanline.h"

#include "image/refuse.h"

#include <algorithm>
#include <cstring>

namespace lambent::image {
namespace {

constexpr int longest_literal = 128;

template <class... Parts>
[[noreturn]] void refuse_scanline(const ScanlineId& id, const Parts&... parts)
{
    refuse(id.file, "scanline ", id.index, ": ", parts...);
}

// Length of a scanline of planes in bytes; nothing if `bytes` end first.
std::optional<std::size_t> end_of_planes(std::span<const std::uint8_t> bytes, int length,
                                         const ScanlineId& id)
{
    std::size_t at = 4;
    for (int plane = 0; plane < 4; ++plane) {
        int left = length;
        while (left > 0) {
            if (at >= bytes.size())
                return std::nullopt;
            const int code = bytes[at];
            const bool run = code > longest_literal;
            left -= run ? code - longest_literal : code;
            at += run ? 2u : static_cast<std::size_t>(code) + 1;
            if (code == 0)
                refuse_scanline(id, "a packet of zero bytes");
        }
        if (left < 0)
            refuse_scanline(id, "a packet goes beyond its end");
    }
    return at <= bytes.size() ? std::optional(at) : std::nullopt;
}

bool is_repeat(const std::uint8_t* pixel)
{
    return pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1;
}

bool is_flat(std::span<const std::uint8_t> bytes, int length)
{
    const std::size_t size = static_cast<std::size_t>(length) * 4;
    if (bytes.size() < size)
        return false;
    bool repeats = false;
    for (std::size_t at = 0; at < size; at += 4)
        repeats |= is_repeat(bytes.data() + at);
    return !repeats;
}

// Length of a scanline of pixels and repeats in bytes; nothing if `bytes` end first.
std::optional<std::size_t> end_of_pixels(std::span<const std::uint8_t> bytes, int length,
                                         const ScanlineId& id)
{
    int shift = 0;
    std::int64_t left = length;
    std::size_t at = 0;
    for (; left > 0; at += 4) {
        if (bytes.size() - at < 4)
            return std::nullopt;
        const std::uint8_t* const pixel = bytes.data() + at;
        if (!is_repeat(pixel)) {
            --left;
            shift = 0;
            continue;
        }
        if (at == 0)
            refuse_scanline(id, "a repeat count before the first pixel");
        if (shift > 16)
            refuse_scanline(id, "more than three repeat counts in a row");
        left -= std::int64_t{pixel[3]} << shift;
        shift += 8;
    }
    if (left < 0)
        refuse_scanline(id, "a repeat count goes beyond its end");
    return at;
}

// Copies 16 bytes at a time, if need be past the end (scanline_slack). Most packets are shorter, so that the
// loop's branch is predicted well.
void copy_steps(std::uint8_t* to, const std::uint8_t* from, int count)
{
    for (int done = 0; done < count; done += 16)
        std::memcpy(to + done, from + done, 16);
}

void fill_steps(std::uint8_t* to, std::uint8_t value, int count)
{
    for (int done = 0; done < count; done += 16)
        std::memset(to + done, value, 16);
}

} // namespace

std::optional<Scanline> find_scanline(std::span<const std::uint8_t> bytes, int length, const ScanlineId& id)
{
    if (has_planes(length)) {
        if (bytes.size() < 4)
            return std::nullopt;
        if (bytes[0] == 2 && bytes[1] == 2 && bytes[2] < 128) {
            if (bytes[2] * 256 + bytes[3] != length)
                refuse_scanline(id, "it is ", bytes[2] * 256 + bytes[3], " pixels long instead of ", length);
            const auto end = end_of_planes(bytes, length, id);
            return end ? std::optional(Scanline{ScanlineKind::planes, *end}) : std::nullopt;
        }
    }
    if (is_flat(bytes, length))
        return Scanline{ScanlineKind::flat, static_cast<std::size_t>(length) * 4};
    const auto end = end_of_pixels(bytes, length, id);
    return end ? std::optional(Scanline{ScanlineKind::pixels, *end}) : std::nullopt;
}

void decode_planes(const std::uint8_t* bytes, int length, std::uint8_t* planes)
{
    // find_scanline has checked that no packet crosses into the next plane.
    const std::uint8_t* const end = planes + static_cast<std::size_t>(length) * 4;
    bytes += 4;
    while (planes < end) {
        const int code = *bytes;
        if (code > longest_literal) {
            fill_steps(planes, bytes[1], code - longest_literal);
            planes += code - longest_literal;
            bytes += 2;
        } else {
            copy_steps(planes, bytes + 1, code);
            planes += code;
            bytes += code + 1;
        }
    }
}

void decode_pixels(const std::uint8_t* bytes, int length, Rgbe* pixels)
{
    Rgbe* const end = pixels + length;
    for (int shift = 0; pixels < end; bytes += 4) {
        if (is_repeat(bytes)) {
            const std::size_t count = std::size_t{bytes[3]} << shift;
            std::fill_n(pixels, count, pixels[-1]);
            pixels += count;
            shift += 8;
        } else {
            std::memcpy(pixels++, bytes, 4);
            shift = 0;
        }
    }
}

} // namespace lambent::image
