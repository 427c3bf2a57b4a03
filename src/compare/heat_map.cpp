#include "compare/heat_map.h"

#include "compare/pixel_font.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace lambent::compare {
namespace {

// The bar and its figures, at the scale of the text.
constexpr int bar_height = 8, gap = 4, ticks = 4;

std::string figure(double value)
{
    char word[32];
    std::snprintf(word, sizeof word, "%.3g", value);
    return word;
}

void set(image::CodeImage& image, int x, int y, const HeatColor& color)
{
    std::uint8_t* out =
        image.bytes.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                  static_cast<std::size_t>(x));
    out[0] = color.r, out[1] = color.g, out[2] = color.b;
}

void draw_legend(image::CodeImage& image, int top, int scale, const Legend& legend)
{
    const int left = gap * scale, width = std::max(image.width - 2 * left, 1);
    for (int y = 0; y < bar_height * scale; ++y)
        for (int x = 0; x < std::min(width, image.width - left); ++x)
            set(image, left + x, top + gap * scale + y,
                heat_color(static_cast<float>(x) / static_cast<float>(std::max(width - 1, 1))));
    const int figures = top + (2 * gap + bar_height) * scale;
    for (int tick = 0; tick <= ticks; ++tick) {
        const std::string word = figure(static_cast<double>(legend.most) * tick / ticks);
        const int size = (text_width(word) - 1) * scale;
        const int x =
            std::clamp(left + width * tick / ticks - size / 2, left, std::max(left, left + width - size));
        write_text(image, {x, figures, scale}, word);
    }
    write_text(image, {left, figures + (glyph_height + gap) * scale, scale},
               legend.title + "  mean " + figure(legend.mean));
}

template <class Value>
Plane difference(const image::RadianceImage& picture, const image::RadianceImage& reference,
                 const Value& value)
{
    Plane plane(picture.width, picture.height);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            const float *a = picture.pixel(x, y), *b = reference.pixel(x, y);
            const float most =
                std::max({std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2])});
            plane.row(y)[x] = value(most, b);
        }
    return plane;
}

} // namespace

HeatColor heat_color(float value)
{
    constexpr double start = 0.5, turns = -1.5, saturation = 1.0;
    const double t = std::clamp(static_cast<double>(value), 0.0, 1.0);
    const double amplitude = saturation * t * (1.0 - t) / 2.0;
    const double angle = 2.0 * std::numbers::pi * (start / 3.0 + 1.0 + turns * t);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const auto code = [&](double along, double aside) {
        const double v = t + amplitude * (along * cosine + aside * sine);
        return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(v, 0.0, 1.0)));
    };
    return {code(-0.14861, 1.78277), code(-0.29227, -0.90649), code(1.97294, 0.0)};
}

image::CodeImage heat_map(const Plane& values, const Legend& legend)
{
    const int scale = std::clamp(values.width / 400, 1, 8);
    const int legend_height = scale * (4 * gap + bar_height + 2 * glyph_height);
    image::CodeImage image{values.width, values.height + legend_height, 3, 8, {}};
    image.bytes.resize(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < values.width; ++x)
            set(image, x, y, heat_color(values.row(y)[x] / legend.most));
    draw_legend(image, values.height, scale, legend);
    return image;
}

Plane relative_difference(const image::RadianceImage& picture, const image::RadianceImage& reference)
{
    double sum = 0.0;
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x)
            for (int c = 0; c < 3; ++c)
                sum += static_cast<double>(reference.pixel(x, y)[c]);
    const float floor =
        static_cast<float>(std::max(0.01 * sum / (3.0 * reference.width * reference.height), 1e-20));
    return difference(picture, reference, [floor](float most, const float* b) {
        return most / ((b[0] + b[1] + b[2]) / 3.0f + floor);
    });
}

Plane absolute_difference(const image::RadianceImage& picture, const image::RadianceImage& reference)
{
    return difference(picture, reference, [](float most, const float*) { return most; });
}

} // namespace lambent::compare
