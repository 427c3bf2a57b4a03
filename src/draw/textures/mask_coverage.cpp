#include "draw/textures/mask_coverage.h"

#include <algorithm>
#include <cmath>

namespace lambent::draw {
namespace {

// Share of a segment where the value, interpolated linearly from a to b, is at least `least`.
float share_from(float a, float b, float least)
{
    const float high = std::max(a, b), low = std::min(a, b);
    if (low >= least)
        return 1.0f;
    return high < least ? 0.0f : (high - least) / (high - low);
}

} // namespace

float covered_share(const AlphaAround& around, float least, bool in_blocks)
{
    const float* const first = &around.alpha[0][0];
    const auto [low, high] = std::minmax_element(first, first + 9);
    if (*low >= least || *high < least)
        return *low >= least ? 1.0f : 0.0f;
    if (in_blocks)
        return around.alpha[1][1] >= least ? 1.0f : 0.0f;
    constexpr int rows = 8;
    float sum = 0.0f;
    for (int i = 0; i < rows; ++i) {
        const float down = (static_cast<float>(i) + 0.5f) / rows - 0.5f, part = std::fabs(down);
        const float* const other = around.alpha[down < 0.0f ? 0 : 2];
        float at[3];
        for (int c = 0; c < 3; ++c)
            at[c] = (1.0f - part) * around.alpha[1][c] + part * other[c];
        sum += share_from(0.5f * (at[0] + at[1]), at[1], least) +
               share_from(at[1], 0.5f * (at[1] + at[2]), least);
    }
    return sum / (2.0f * rows);
}

float least_mask_alpha(const scene::Material& material, float vertex_alpha)
{
    constexpr float never = 2.0f;
    const float factor = material.base_color.a * vertex_alpha;
    if (!(material.alpha_cutoff > 0.0f))
        return 0.0f;
    return factor > 0.0f ? std::min(material.alpha_cutoff / factor, never) : never;
}

} // namespace lambent::draw
