// Luminance of linear light.
#pragma once

namespace lambent::image {

/// Luminance of linear RGB with Rec. 709 primaries, in the unit of r, g and b. [ITU-R BT.709-6, item 3.2]
constexpr double luminance(double r, double g, double b)
{
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/// The same for three consecutive values, such as a pixel or the elements of a vector.
template <class Value>
constexpr double luminance(const Value* rgb)
{
    return luminance(static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2]));
}

} // namespace lambent::image
