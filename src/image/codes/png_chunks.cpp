#include "image/codes/png_chunks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace lambent::image {
namespace {

constexpr std::size_t signature_size = 8, head_size = 8, checksum_size = 4;

std::uint32_t big_endian(std::span<const std::uint8_t> bytes)
{
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 |
           bytes[3];
}

bool is_needed(std::span<const std::uint8_t> name)
{
    constexpr std::array<std::string_view, 4> needed = {"IHDR", "PLTE", "tRNS", "IDAT"};
    return std::any_of(needed.begin(), needed.end(), [&](std::string_view known) {
        return std::equal(known.begin(), known.end(), name.begin(), name.end());
    });
}

void append_bytes(std::vector<std::uint8_t>& to, std::span<const std::uint8_t> bytes)
{
    to.insert(to.end(), bytes.begin(), bytes.end());
}

} // namespace

std::vector<std::uint8_t> needed_chunks(std::span<const std::uint8_t> bytes)
{
    static constexpr std::array<std::uint8_t, 12> end = {0,   0,   0,    0,    'I',  'E',
                                                         'N', 'D', 0xae, 0x42, 0x60, 0x82};
    std::vector<std::uint8_t> needed;
    needed.reserve(bytes.size() + 2 * end.size());
    append_bytes(needed, bytes.first(std::min(bytes.size(), signature_size)));
    std::size_t at = signature_size;
    while (at < bytes.size() && bytes.size() - at > head_size) {
        const std::span<const std::uint8_t> name = bytes.subspan(at + 4, 4);
        const std::size_t left = bytes.size() - at - head_size,
                          length = std::min<std::size_t>(big_endian(bytes.subspan(at)), left);
        if (is_needed(name)) {
            for (int shift = 24; shift >= 0; shift -= 8)
                needed.push_back(static_cast<std::uint8_t>(length >> shift));
            append_bytes(needed, bytes.subspan(at + 4, 4 + length));
            append_bytes(needed,
                         bytes.subspan(at + head_size + length, std::min(left - length, checksum_size)));
            needed.resize(needed.size() + checksum_size - std::min(left - length, checksum_size));
        }
        at += head_size + length + std::min(left - length, checksum_size);
    }
    append_bytes(needed, end);
    return needed;
}

} // namespace lambent::image
