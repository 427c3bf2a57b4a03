// One channel of a picture, and filters that are a product of a row and a column.
#pragma once

#include <cstddef>
#include <vector>

namespace lambent::compare {

struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int w, int h)
        : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h))
    {
    }
    float* row(int y)
    {
        return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
    const float* row(int y) const
    {
        return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
};

/// Weights at -radius to radius.
using Kernel = std::vector<float>;

/// The plane filtered by `across` along its rows, then by `down` along its columns; at the borders the outermost values
/// go on. result(x) = sum over i of kernel(i) plane(x + i). Kernels have odd lengths.
Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down);

} // namespace lambent::compare
