// Errors of the glTF loader.
#pragma once

#include "base/error.h"
#include "base/text.h"

#include <string>
#include <string_view>

namespace lambent::scene {

/// Throws Error(bad_input) with all arguments as one line.
template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts)
{
    throw Error(Failure::bad_input, text(parts...));
}

/// Text from a file, made safe to show: control characters become '?', and it is cut off after 200 bytes.
std::string printable(std::string_view text);

} // namespace lambent::scene
