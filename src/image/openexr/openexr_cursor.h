// Reads numbers and names from the bytes of an OpenEXR header.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace lambent::image {

/// The first four bytes as an unsigned number, lowest byte first.
inline std::uint32_t little_endian(const std::uint8_t* bytes)
{
    return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
}

/// The same as a signed number.
inline std::int32_t signed_little_endian(const std::uint8_t* bytes)
{
    return static_cast<std::int32_t>(little_endian(bytes));
}

/// Reads consecutive values from a span.
class ExrCursor {
public:
    /// Thrown when a value extends beyond the span.
    struct NeedsMore {};

    explicit ExrCursor(std::span<std::uint8_t> bytes) : bytes_(bytes) {}

    /// Number of bytes read so far.
    std::size_t at() const { return at_; }

    std::span<std::uint8_t> take(std::size_t count)
    {
        if (count > bytes_.size() - at_)
            throw NeedsMore();
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }

    std::uint32_t take_word() { return little_endian(take(4).data()); }

    /// Takes a zero-terminated name.
    std::string_view take_name()
    {
        const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
        const auto end = std::find(begin, bytes_.end(), std::uint8_t{0});
        if (end == bytes_.end())
            throw NeedsMore();
        const auto length = static_cast<std::size_t>(end - begin);
        const std::span<std::uint8_t> name = take(length + 1);
        return {reinterpret_cast<const char*>(name.data()), length};
    }

private:
    std::span<std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

} // namespace lambent::image
