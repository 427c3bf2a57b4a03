#include "scene/builtin/painted_textures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambent::scene {
namespace {

using Color = std::array<double, 3>; // sRGB, 0 to 1

void put(image::CodeImage& image, int x, int y, const Color& color)
{
    const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(x));
    for (std::size_t c = 0; c < 3; ++c)
        image.bytes[at + c] = static_cast<std::uint8_t>(std::lround(255.0 * color[c]));
    image.bytes[at + 3] = 255;
}

image::CodeImage blank(int width, int height)
{
    image::CodeImage image{width, height, 4, 8, {}};
    image.bytes.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    return image;
}

// The saturated colour of a hue (in turns), mixed with white and black in proportions from 0 to 1.
Color paint(double hue, double whiteness, double darkness)
{
    Color color{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double away = std::abs(std::remainder(hue - static_cast<double>(c) / 3.0, 1.0));
        const double strong = std::clamp(2.0 - 6.0 * away, 0.0, 1.0);
        color[c] = (strong + (1.0 - strong) * whiteness) * (1.0 - darkness);
    }
    return color;
}

} // namespace

image::CodeImage color_chart()
{
    constexpr int columns = 18, rows = 8, cell = 32, joint = 2;
    constexpr std::array<double, rows> white = {0.85, 0.75, 0.6, 0.42, 0.26, 0.16, 0.12, 0.1},
                                       dark = {0.08, 0.08, 0.08, 0.08, 0.1, 0.25, 0.45, 0.65};
    image::CodeImage image = blank(columns * cell, rows * cell);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool between = x % cell < joint || y % cell < joint;
            const auto row = static_cast<std::size_t>(y / cell);
            const int column = x / cell;
            const double hue = column / static_cast<double>(columns);
            put(image, x, y, between ? Color{0.86, 0.85, 0.82} : paint(hue, white[row], dark[row]));
        }
    return image;
}

image::CodeImage floor_tiles()
{
    constexpr int cell = 64, joint = 2;
    constexpr Color joints = {0.62, 0.6, 0.57}, first = {0.55, 0.33, 0.22}, second = {0.78, 0.7, 0.58};
    image::CodeImage image = blank(2 * cell, 2 * cell);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool between = x % cell < joint || y % cell < joint;
            const bool even = (x / cell + y / cell) % 2 == 0;
            put(image, x, y, between ? joints : even ? first : second);
        }
    return image;
}

} // namespace lambent::scene
