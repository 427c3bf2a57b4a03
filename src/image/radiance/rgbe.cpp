#include "image/radiance/rgbe.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lambent::image {
namespace {

// The value of mantissa 1 for each exponent byte. With this table the conversion runs at memory speed.
const std::array<float, 256>& mantissa_steps()
{
    static const std::array<float, 256> steps = [] {
        std::array<float, 256> table{};
        for (int e = 1; e < 256; ++e)
            table[static_cast<std::size_t>(e)] = std::ldexp(1.0f, e - 136);
        return table;
    }();
    return steps;
}

// 2^exponent as a double: products with floats are exact in double, and subnormal floats are normal doubles.
double power_of_two(int exponent)
{
    return std::bit_cast<double>(static_cast<std::int64_t>(exponent + 1023) << 52);
}

// The largest k with 2^k <= value, for positive values.
int floor_log2(double value)
{
    return static_cast<int>(std::bit_cast<std::int64_t>(value) >> 52) - 1023;
}

// The mantissa, rounded. It is clamped to 255, which only matters at the largest exponent.
std::uint8_t mantissa(float value, double steps_per_unit)
{
    const double steps = value > 0.0f ? value * steps_per_unit : 0.0;
    return static_cast<std::uint8_t>(std::min(steps + 0.5, 255.0));
}

} // namespace

void planes_to_rgb(const std::uint8_t* planes, std::size_t count, const ChannelScale& scale, float* rgb)
{
    const std::uint8_t* const green = planes + count;
    const std::uint8_t* const blue = green + count;
    const std::uint8_t* const exponent = blue + count;
    const std::array<float, 256>& steps = mantissa_steps();
    const auto [scale_red, scale_green, scale_blue] = scale;
    for (std::size_t i = 0; i < count; ++i) {
        const float step = steps[exponent[i]];
        rgb[3 * i + 0] = static_cast<float>(planes[i]) * step * scale_red;
        rgb[3 * i + 1] = static_cast<float>(green[i]) * step * scale_green;
        rgb[3 * i + 2] = static_cast<float>(blue[i]) * step * scale_blue;
    }
}

void pixels_to_rgb(const Rgbe* pixels, std::size_t count, const ChannelScale& scale, float* rgb)
{
    const std::array<float, 256>& steps = mantissa_steps();
    const auto [scale_red, scale_green, scale_blue] = scale;
    for (std::size_t i = 0; i < count; ++i) {
        const auto [red, green, blue, exponent] = pixels[i];
        const float step = steps[exponent];
        rgb[3 * i + 0] = static_cast<float>(red) * step * scale_red;
        rgb[3 * i + 1] = static_cast<float>(green) * step * scale_green;
        rgb[3 * i + 2] = static_cast<float>(blue) * step * scale_blue;
    }
}

Rgbe to_rgbe(float red, float green, float blue)
{
    // Comparisons with NaN are false, so that NaN counts as 0.
    float largest = 0.0f;
    for (const float value : {red, green, blue})
        largest = value > largest ? value : largest;
    constexpr float smallest = 0x1p-128f;
    if (largest < smallest)
        return {0, 0, 0, 0};

    // With this exponent e, largest / 2^(e-136) is in [128, 256).
    int exponent = std::min(floor_log2(largest) + 129, 255);
    // From 255.5 on the mantissa would round to 256, which is 128 with the next exponent.
    if (exponent < 255 && largest * power_of_two(136 - exponent) >= 255.5)
        ++exponent;
    const double steps_per_unit = power_of_two(136 - exponent);
    return {mantissa(red, steps_per_unit), mantissa(green, steps_per_unit), mantissa(blue, steps_per_unit),
            static_cast<std::uint8_t>(exponent)};
}

} // namespace lambent::image
