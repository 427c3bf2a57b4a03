// Luminance of linear light.
#pragma once

namespace lambent::image {

/// Of linear RGB with the primaries of Rec. 709, in the unit of its parts. [ITU-R BT.709-6, item 3.2]
constexpr double luminance(double r, double g, double b)
{
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/// The same of three values side by side: a pixel, or a vector's or an array's parts.
template <class Value>
constexpr double luminance(const Value* rgb)
{
    return luminance(static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2]));
}

} // namespace lambent::image
