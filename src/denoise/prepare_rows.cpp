#include "denoise/prepare_rows.h"

#include <algorithm>
#include <cmath>

namespace lambent::denoise {
namespace {

// Narrow lobes see other things when the normal turns by less than their width.
float lobe_power(float alpha)
{
    return std::clamp(2.0f / std::max(alpha * alpha, 1.0e-6f), 32.0f, 1.0e5f);
}

std::size_t pixel_of(const RowSpan& span, int width)
{
    return static_cast<std::size_t>(span.y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(span.first);
}

// One plane, 0 where nothing is covered.
void copy_covered(const float* from, const float* covered, int columns, float* to)
{
    for (int x = 0; x < columns; ++x)
        to[x] = covered[x] > 0.0f ? from[x] : 0.0f;
}

float lesser(float a, float b)
{
    return std::fabs(a) < std::fabs(b) ? a : b;
}

// A surface's change of depth from pixel to pixel.
float slope_between(float depth, float before, float after, bool has_before, bool has_after)
{
    const float backward = depth - before, forward = after - depth;
    const float both = lesser(backward, forward);
    const float slope = has_before ? (has_after ? both : backward) : (has_after ? forward : 0.0f);
    return std::clamp(slope, -0.1f * depth, 0.1f * depth);
}

// A plane of each of the halves' sums.
struct SumRows {
    float *unshadowed, *change;
};

void add_half(const Half& half, std::size_t at, int channel, const float* scale, int columns, SumRows to)
{
    const auto c = static_cast<std::size_t>(channel);
    const float* const unshadowed = half.unshadowed[c].data() + at;
    const float* const found = half.found[c].data() + at;
    for (int x = 0; x < columns; ++x) {
        const bool covered = scale[x] > 0.0f;
        to.unshadowed[x] = covered ? scale[x] * unshadowed[x] : 0.0f;
        to.change[x] = covered ? scale[x] * (found[x] - unshadowed[x]) : 0.0f;
    }
}

} // namespace

void prepare_guides(const Guides& guides, int width, const RowSpan& span, float* to)
{
    const std::size_t at = pixel_of(span, width);
    float* const covered = to + covered_plane * span.pitch;
    for (int x = 0; x < span.columns; ++x)
        covered[x] = guides.coverage[at + static_cast<std::size_t>(x)] > 0.0f ? 1.0f : 0.0f;
    const auto copy = [&](const Plane& from, int plane) {
        copy_covered(from.data() + at, covered, span.columns, to + plane * span.pitch);
    };
    for (int c = 0; c < 3; ++c)
        copy(guides.normal[static_cast<std::size_t>(c)], normal_plane + c);
    copy(guides.depth, depth_plane);
    copy(guides.metalness, metalness_plane);
    copy(guides.alpha, roughness_plane);
    float* const roughness = to + roughness_plane * span.pitch;
    float* const power = to + power_plane * span.pitch;
    for (int x = 0; x < span.columns; ++x) {
        power[x] = lobe_power(roughness[x]);
        roughness[x] = std::sqrt(std::max(roughness[x], 0.0f));
    }
}

void prepare_slopes(const float* above, float* row, const float* below, const RowSpan& span)
{
    const std::ptrdiff_t depth = depth_plane * span.pitch, covered = covered_plane * span.pitch;
    for (int x = 0; x < span.columns; ++x) {
        const float* const here = row + depth + x;
        const float* const is = row + covered + x;
        row[slope_x_plane * span.pitch + x] =
            slope_between(*here, here[-1], here[1], is[-1] > 0.0f, is[1] > 0.0f);
        row[slope_y_plane * span.pitch + x] = slope_between(
            *here, above[depth + x], below[depth + x], above[covered + x] > 0.0f, below[covered + x] > 0.0f);
    }
}

void prepare_light(const LightJob& job, const RowSpan& span, float* given, float* sums)
{
    // Pixels of little albedo weigh little, since what they received is known little.
    constexpr float least_albedo = 1.0e-5f, little_albedo = 0.01f;
    const Picture& picture = job.picture;
    const std::size_t at = pixel_of(span, picture.width);
    const std::ptrdiff_t pitch = span.pitch;
    float* const weight = given + given_weight * pitch;
    for (int x = 0; x < span.columns; ++x) {
        const std::size_t i = at + static_cast<std::size_t>(x);
        const float coverage = picture.guides.coverage[i];
        weight[x] = coverage > 0.0f ? coverage * picture.count[i] : 0.0f;
    }
    for (int c = 0; c < 3; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        copy_covered(job.light.exact[channel].data() + at, weight, span.columns,
                     given + (given_exact + c) * pitch);
        float* const albedo = given + (given_albedo + c) * pitch;
        const bool textured = !job.light.albedo[channel].empty();
        float* const scale = sums + (sum_weight + (textured ? c : 0)) * pitch; // becomes the weight last
        for (int x = 0; x < span.columns; ++x) {
            const float own = textured && weight[x] > 0.0f
                                  ? job.light.albedo[channel][at + static_cast<std::size_t>(x)]
                                  : 1.0f;
            albedo[x] = textured ? std::max(own, least_albedo) : 1.0f;
            scale[x] = textured ? weight[x] / (albedo[x] + little_albedo) : weight[x];
        }
        for (int half = 0; half < 2; ++half)
            add_half(
                job.light.halves[static_cast<std::size_t>(half)], at, c, scale, span.columns,
                {sums + (6 * half + sum_unshadowed + c) * pitch, sums + (6 * half + sum_change + c) * pitch});
        for (int x = 0; x < span.columns && textured; ++x)
            scale[x] *= albedo[x];
    }
}

} // namespace lambent::denoise
