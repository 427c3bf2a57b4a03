#include "environment/builtin/kitchen.h"

#include "image/files/image_io.h"
#include "image/panorama_lookup.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

// Embeds the file's bytes in the program, for which C++20 has no language feature.
asm(".section .rodata\n"
    ".global lambent_kitchen_begin\n"
    ".global lambent_kitchen_end\n"
    "lambent_kitchen_begin:\n"
    ".incbin \"" LAMBENT_KITCHEN_FILE "\"\n"
    "lambent_kitchen_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
extern const std::uint8_t lambent_kitchen_begin[];
extern const std::uint8_t lambent_kitchen_end[];
}

namespace lambent::environment {
namespace {

// Half as wide and high: each texel is the mean of four by their solid angle.
image::RadianceImage halved(const image::RadianceImage& from)
{
    image::RadianceImage to = image::black_image(from.width / 2, from.height / 2);
    const double step = std::numbers::pi / from.height;
    tbb::parallel_for(0, to.height, [&](int y) {
        const double top = std::cos(2 * y * step), middle = std::cos((2 * y + 1) * step),
                     bottom = std::cos((2 * y + 2) * step);
        const float upper = static_cast<float>(0.5 * (top - middle) / (top - bottom)), lower = 0.5f - upper;
        for (int x = 0; x < to.width; ++x)
            for (int c = 0; c < 3; ++c)
                to.pixel(x, y)[c] =
                    upper * (from.pixel(2 * x, 2 * y)[c] + from.pixel(2 * x + 1, 2 * y)[c]) +
                    lower * (from.pixel(2 * x, 2 * y + 1)[c] + from.pixel(2 * x + 1, 2 * y + 1)[c]);
    });
    return to;
}

// Twice as wide and high, bilinear, across the poles too.
image::RadianceImage doubled(const image::RadianceImage& from)
{
    image::RadianceImage to = image::black_image(2 * from.width, 2 * from.height);
    tbb::parallel_for(0, to.height, [&](int y) {
        const int near_y = y / 2, far_y = near_y + (y % 2 == 0 ? -1 : 1);
        const auto texel = [&](int x, int row) {
            const image::PanoramaTexel at = image::texel_across(x, row, from.width, from.height);
            return from.pixel(at.x, at.y);
        };
        for (int x = 0; x < to.width; ++x) {
            const int near_x = x / 2, far_x = near_x + (x % 2 == 0 ? -1 : 1);
            const float *nearest = texel(near_x, near_y), *beside = texel(far_x, near_y);
            const float *next = texel(near_x, far_y), *diagonal = texel(far_x, far_y);
            for (int c = 0; c < 3; ++c)
                to.pixel(x, y)[c] =
                    0.5625f * nearest[c] + 0.1875f * (beside[c] + next[c]) + 0.0625f * diagonal[c];
        }
    });
    return to;
}

} // namespace

image::RadianceImage make_kitchen(int width)
{
    const std::span<const std::uint8_t> bytes(lambent_kitchen_begin, lambent_kitchen_end);
    image::RadianceImage panorama = image::decode_radiance(bytes, "the built-in kitchen");
    while (panorama.width > width)
        panorama = halved(panorama);
    while (panorama.width < width)
        panorama = doubled(panorama);
    // Half floats of a lossy file may fall a little below 0.
    for (float& value : panorama.values)
        value = std::max(value, 0.0f);
    return panorama;
}

} // namespace lambent::environment
