// Files in the making.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lambent::test {

using Bytes = std::vector<std::uint8_t>;

inline Bytes bytes_of(const std::string& text)
{
    return {text.begin(), text.end()};
}

inline Bytes operator+(Bytes a, const Bytes& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

} // namespace lambent::test
