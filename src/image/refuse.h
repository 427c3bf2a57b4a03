// Errors of the image readers, and the limits on the size of images.
#pragma once

#include "base/error.h"
#include "base/text.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace lambent::image {

/// Throws Error(bad_input) with the line "name: parts...".
template <class... Parts>
[[noreturn]] void refuse(const std::string& name, const Parts&... parts)
{
    throw Error(Failure::bad_input, text(name, ": ", parts...));
}

/// Largest width, height and number of pixels of images read or written.
inline constexpr std::int64_t max_side = 65536;
inline constexpr std::int64_t max_pixels = std::int64_t{1} << 28;

/// Refuses a width and height that are not positive or exceed the limits above.
void check_size(const std::string& name, std::int64_t width, std::int64_t height);

/// Bytes of a file for use in a message: everything but printable ASCII becomes '?', and text beyond `longest`
/// characters is cut off.
std::string printable(std::string_view bytes, std::size_t longest = 60);

} // namespace lambent::image
