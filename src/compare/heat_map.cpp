#include "compare/heat_map.h"

#include "compare/color_map.h"
#include "compare/pixel_font.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace lambent::compare {
namespace {

constexpr int ticks = 5;
constexpr Code paper = {24, 24, 24}, ink = {235, 235, 235};

// Sizes of the legend, in pixels at scale 1.
constexpr int margin = 6, gap = 4, bar_height = 10, tick_height = 3, least_width = 220;

std::string number(double value)
{
    char words[32];
    std::snprintf(words, sizeof words, "%.3g", value);
    return words;
}

struct Layout {
    int scale, width, map_height, title_y, bar_y, number_y, height;

    int left() const { return margin * scale; }
    int bar_width() const { return width - 2 * margin * scale; }
};

Layout layout_of(const ErrorMap& map)
{
    Layout layout{};
    layout.scale = std::clamp(map.width / 640, 1, 8);
    layout.width = std::max(map.width, least_width);
    layout.map_height = map.height;
    const int s = layout.scale;
    layout.title_y = map.height + margin * s;
    layout.bar_y = layout.title_y + (letter_height + gap) * s;
    layout.number_y = layout.bar_y + (bar_height + tick_height + 2) * s;
    layout.height = layout.number_y + (letter_height + margin) * s;
    return layout;
}

void put(image::CodeImage& image, int x, int y, const Code& color)
{
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
    std::copy(color.begin(), color.end(), image.bytes.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
}

void draw_bar(image::CodeImage& image, const Layout& layout)
{
    const int s = layout.scale, last = layout.bar_width() - 1;
    for (int x = 0; x <= last; ++x)
        for (int y = 0; y < bar_height * s; ++y)
            put(image, layout.left() + x, layout.bar_y + y,
                color_of(static_cast<float>(x) / static_cast<float>(last)));
    for (int i = 0; i < ticks; ++i)
        for (int x = 0; x < s; ++x)
            for (int y = 0; y < tick_height * s; ++y)
                put(image, layout.left() + (layout.bar_width() - s) * i / (ticks - 1) + x,
                    layout.bar_y + bar_height * s + y, ink);
}

void draw_numbers(image::CodeImage& image, const Layout& layout, double top)
{
    for (int i = 0; i < ticks; ++i) {
        const std::string words = number(top * i / (ticks - 1));
        const int width = text_width(words, layout.scale);
        const int tick = layout.left() + layout.bar_width() * i / (ticks - 1);
        const int x = std::clamp(tick - width / 2, layout.left(), layout.left() + layout.bar_width() - width);
        draw_text(image, words, {x, layout.number_y, layout.scale}, ink);
    }
}

} // namespace

image::CodeImage heat_map(const ErrorMap& map, const HeatLegend& legend)
{
    const Layout layout = layout_of(map);
    image::CodeImage image{layout.width, layout.height, 3, 8, {}};
    image.bytes.assign(static_cast<std::size_t>(layout.width) * static_cast<std::size_t>(layout.height) * 3,
                       paper[0]);
    const auto factor = static_cast<float>(1.0 / legend.top);
    tbb::parallel_for(0, map.height, [&](int y) {
        const float* row =
            map.values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width);
        for (int x = 0; x < map.width; ++x)
            put(image, x, y, color_of(row[x] * factor));
    });
    const std::string mean = "mean " + number(legend.mean);
    draw_text(image, legend.title, {layout.left(), layout.title_y, layout.scale}, ink);
    const int right = layout.left() + layout.bar_width() - text_width(mean, layout.scale);
    draw_text(image, mean, {right, layout.title_y, layout.scale}, ink);
    draw_bar(image, layout);
    draw_numbers(image, layout, legend.top);
    return image;
}

double round_top(const ErrorMap& map)
{
    const auto largest = std::max_element(map.values.begin(), map.values.end());
    if (largest == map.values.end() || !(*largest > 0.0f))
        return 1.0;
    const double value = static_cast<double>(*largest);
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * power * (1.0 + 1e-6))
            return step * power;
    return 10.0 * power;
}

} // namespace lambent::compare
