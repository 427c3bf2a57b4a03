// A file's numbers are int, ours are std::size_t.
#pragma once

#include <cstddef>

namespace lambent::scene {

/// An index that was checked: not below 0.
constexpr std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

} // namespace lambent::scene
