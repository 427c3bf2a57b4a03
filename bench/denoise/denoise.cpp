// The filter of both classes of light against its sums alone: 28 planes through four levels of the a-trous filter, plain
// loops without guides and choices. In one run, with each instruction set of the processor.
#include "bench/side_by_side.h"
#include "denoise/light_filter.h"
#include "wide/instruction_sets.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstddef>
#include <random>

namespace {

using namespace lambent;
using denoise::Plane;
using denoise::Rgb;

constexpr int width = 1280, height = 720;
constexpr std::size_t size = static_cast<std::size_t>(width) * height;

Rgb filled(float value)
{
    return {Plane(size, value), Plane(size, value), Plane(size, value)};
}

// Light of which a random half arrives.
denoise::Light make_light(std::mt19937& random, bool textured)
{
    denoise::Light light;
    light.exact = filled(0.5f);
    if (textured)
        light.albedo = filled(0.5f);
    std::bernoulli_distribution arrives(0.5);
    for (denoise::Half& half : light.halves) {
        half.unshadowed = half.found = filled(0.5f);
        for (Plane& plane : half.found)
            for (float& value : plane)
                value = arrives(random) ? value : 0.0f;
    }
    return light;
}

// Balls in rows that cover 55 % of the picture.
denoise::Picture make_picture()
{
    denoise::Picture picture{width, height, {}, Plane(size, 4.0f), {}, {}};
    std::mt19937 random(1);
    picture.diffuse = make_light(random, true);
    picture.specular = make_light(random, false);
    denoise::Guides& guides = picture.guides;
    guides = {Plane(size), filled(0.0f), Plane(size, 5.0f), Plane(size, 0.25f), Plane(size)};
    constexpr float spacing = 80.0f;
    const float radius = spacing * std::sqrt(0.55f / 3.14159265f);
    std::size_t i = 0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column, ++i) {
            const float x = (std::fmod(static_cast<float>(column) + 0.5f, spacing) - 0.5f * spacing) / radius;
            const float y = (std::fmod(static_cast<float>(row) + 0.5f, spacing) - 0.5f * spacing) / radius;
            const float z2 = 1.0f - x * x - y * y;
            if (z2 <= 0.0f)
                continue;
            guides.coverage[i] = 1.0f;
            guides.normal[0][i] = x;
            guides.normal[1][i] = y;
            guides.normal[2][i] = std::sqrt(z2);
            guides.depth[i] = 5.0f - 0.5f * std::sqrt(z2);
        }
    return picture;
}

// 5x5 binomial weights.
void plain_level(const Plane& from, int step, Plane& to)
{
    constexpr float binomial[] = {0.0625f, 0.25f, 0.375f, 0.25f, 0.0625f};
    tbb::parallel_for(2 * step, height - 2 * step, [&](int y) {
        for (int x = 2 * step; x < width - 2 * step; ++x) {
            float sum = 0.0f;
            for (int j = 0; j < 5; ++j)
                for (int i = 0; i < 5; ++i)
                    sum += binomial[j] * binomial[i] *
                           from[static_cast<std::size_t>((y + (j - 2) * step) * width + x + (i - 2) * step)];
            to[static_cast<std::size_t>(y * width + x)] = sum;
        }
    });
}

} // namespace

int main()
{
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
    std::printf("Both classes filtered, 1280x720, 55 %% covered, 2 threads, against their plain sums\n");
    const denoise::Picture picture = make_picture();
    Plane smooth(size);
    for (const std::string& instructions : wide::available_instruction_sets()) {
        if (instructions == "avx")
            continue; // for the filter the same as sse4.2
        wide::limit_instructions(instructions);
        bench::side_by_side(
            instructions, 7, [&] { denoise::filter_light(picture, {}); },
            [&] {
                for (int plane = 0; plane < 28; ++plane)
                    for (int step = 1; step <= 8; step *= 2)
                        plain_level(picture.diffuse.exact[0], step, smooth);
            });
    }
}
