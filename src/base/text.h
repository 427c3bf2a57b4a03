// Small text helpers for messages.
#pragma once

#include <sstream>
#include <string>

namespace lambent {

/// All arguments, streamed one after the other: text("size ", 3, "x", 4) is "size 3x4".
template <class... Parts>
std::string text(const Parts&... parts)
{
    std::ostringstream out;
    (out << ... << parts);
    return out.str();
}

} // namespace lambent
