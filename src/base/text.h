// Small text helpers for messages.
#pragma once

#include <sstream>
#include <string>

namespace lambent {

/// All arguments streamed into one string: text("size ", 3, "x", 4) is "size 3x4".
template <class... Parts>
std::string text(const Parts&... parts)
{
    std::ostringstream out;
    (out << ... << parts);
    return out.str();
}

/// The message with control characters, which names of files may contain, replaced by question marks.
inline std::string one_line(std::string message)
{
    for (char& c : message)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = '?';
    return message;
}

} // namespace lambent
