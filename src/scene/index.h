// Conversion of indices, which are int in files and in the scene, to std::size_t.
#pragma once

#include <cstddef>

namespace lambent::scene {

/// An index that is known not to be negative, as std::size_t.
constexpr std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

} // namespace lambent::scene
