#include "environment/chain/make_chain.h"

#include "environment/chain/cube_faces.h"
#include "environment/chain/kernels.h"
#include "environment/chain/peaks.h"
#include "environment/panorama/round_texels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lambent::environment {
namespace {

// Faces of a quarter of the panorama's width are as sharp as the panorama at their edges; larger ones only cost memory.
constexpr int least_log2_size = 5, most_log2_size = 10;

// Reading a level bilinearly blurs it by this variance, in square texels: the mean of f (1 - f) over a texel.
constexpr double lookup_variance = 1.0 / 6.0;

// Level 0 is not blurred and needs more taps than the later levels.
constexpr int first_rings = 5, later_rings = 4;

int log2_face_size(int panorama_width)
{
    int log2_size = least_log2_size;
    while (log2_size < most_log2_size && (4 << log2_size) < panorama_width)
        ++log2_size;
    return log2_size;
}

float power_of_two_at_least(float value)
{
    return std::exp2(std::ceil(std::log2(std::max(value, 1e-30f))));
}

// The smallest power of two by which the brightest texel fits into a half, with a margin for rounding in resampling.
float chain_scale(float brightest)
{
    return std::max(power_of_two_at_least(brightest / 32768.0f), 0x1p-14f);
}

constexpr float brightest_of_all = std::numeric_limits<float>::max();

struct Resampling {
    const Panorama* panorama;
    float limit;
    std::vector<TexelPoint> points;
};

// A square grid of at least `least_across` points per side.
std::vector<TexelPoint> grid_of_points(double least_across)
{
    const int across = std::max(static_cast<int>(std::ceil(least_across)), 1);
    std::vector<TexelPoint> points;
    for (int i = 0; i < across * across; ++i) {
        const int column = i % across, row = i / across;
        points.push_back({(static_cast<float>(column) + 0.5f) / static_cast<float>(across),
                          (static_cast<float>(row) + 0.5f) / static_cast<float>(across)});
    }
    return points;
}

// Sample positions no further apart than the panorama's texels at a face's centre, where the face's texels are largest.
std::vector<TexelPoint> texel_points(int panorama_width, int face_size, double density = 1.5)
{
    if (panorama_width <= 4 * face_size) // one point is nearly dense enough; two on a diagonal are
        return {{0.25f, 0.75f}, {0.75f, 0.25f}};
    return grid_of_points(density / std::numbers::pi * panorama_width / face_size);
}

// Sample positions a third of a panorama texel apart: so dense that a single bright texel keeps its light.
std::vector<TexelPoint> dense_points(int panorama_width, int face_size)
{
    return grid_of_points(3.0 / std::numbers::pi * panorama_width / face_size);
}

// Texels [first, end) of a row.
struct Range {
    int first, end;
};

// Ranges of each row of level 0, indexed by face * size + y.
using Rows = std::vector<std::vector<Range>>;

void resample(const Resampling& resampling, const Rows& rows, CubeChain& chain)
{
    const int size = chain.face_size(0);
    tbb::parallel_for(0, 6 * size, [&](int index) {
        for (const Range& range : rows[static_cast<std::size_t>(index)])
            resample_row({resampling.panorama, resampling.limit, &resampling.points, index / size,
                          index % size, range.first, range.end},
                         chain);
    });
    fill_borders(chain, 0);
}

Rows all_of(int size)
{
    return {static_cast<std::size_t>(6 * size), {Range{0, size}}};
}

// Joins ranges that overlap or touch.
void merge(std::vector<Range>& ranges)
{
    std::ranges::sort(ranges, {}, &Range::first);
    std::size_t last = 0;
    for (const Range& range : ranges)
        if (range.first <= ranges[last].end)
            ranges[last].end = std::max(ranges[last].end, range.end);
        else
            ranges[++last] = range;
    ranges.resize(std::min(ranges.size(), last + 1));
}

// The texels of level 0 whose lookups may read a panorama texel above the limit.
Rows around(const Peaks& peaks, const Panorama& panorama, int size)
{
    Rows rows(static_cast<std::size_t>(6 * size));
    // From a peak's centre to the end of its texels' bilinear footprint, and half a texel of a face.
    const double texel = std::max(2.0 / panorama.width, 1.0 / panorama.height) * std::numbers::pi;
    const double reach = 2.0 * texel + 1.5 / size;
    for (const Peak& peak : peaks.peaks)
        for (int face = 0; face < 6; ++face) {
            const TexelBox box = texels_within(peak, reach, face, size);
            for (int y = box.y0; box.x0 <= box.x1 && y <= box.y1; ++y)
                rows[static_cast<std::size_t>(face * size + y)].push_back({box.x0, box.x1 + 1});
        }
    for (std::vector<Range>& ranges : rows)
        merge(ranges);
    return rows;
}

// Resamples the texels around the peaks more densely, so that the peaks keep their light.
void resample_peaks(const Panorama& panorama, const Peaks& peaks, CubeChain& chain)
{
    if (peaks.peaks.empty())
        return;
    const int size = chain.face_size(0);
    constexpr float narrow =
        0.8f; // sine of latitude: texels are made round above 60 degrees, and a peak extends beyond its centre
    const bool near_pole = std::ranges::any_of(
        peaks.peaks, [](const Peak& peak) { return std::fabs(peak.direction[1]) > narrow; });
    const Panorama round = near_pole ? with_round_texels(panorama) : Panorama{};
    resample({near_pole ? &round : &panorama, brightest_of_all, dense_points(panorama.width, size)},
             around(peaks, panorama, size), chain);
}

// Standard deviation, in radians, of the blur that makes the next level from this one.
double step_deviation(const CubeChain& chain, int level)
{
    const double texel = std::numbers::pi / 2.0 / chain.face_size(level);
    const double wanted =
        4.0 * (1.0 - lookup_variance); // of the next level as stored, in this level's square texels
    const double present = level == 0 ? 0.25 : 1.0; // of this level as read
    return texel * std::sqrt(wanted - present);
}

void blur_level(int level, CubeChain& chain)
{
    const GaussianTaps taps = gaussian_taps(level == 1 ? first_rings : later_rings,
                                            static_cast<float>(step_deviation(chain, level - 1)));
    const int size = chain.face_size(level);
    tbb::parallel_for(0, 6 * size, [&](int index) {
        blur_row({&taps, level, index / size, index % size}, chain);
    });
    fill_borders(chain, level);
}

void add_peaks(const Peaks& peaks, int level, CubeChain& chain)
{
    const double texel = std::numbers::pi / 2.0 / chain.face_size(level);
    const float deviation = static_cast<float>(texel * std::sqrt(1.0 - lookup_variance));
    add_gaussians(merged(peaks.peaks, deviation / 2.0f), deviation, level, chain);
    fill_borders(chain, level);
}

// `choose` selects the lamps and the last level that includes them.
Blurs build(const Panorama& panorama, Lamps (*choose)(const Peaks&, const CubeChain&))
{
    const int log2_size = log2_face_size(panorama.width);
    if (panorama.width > (6 << log2_size) && panorama.width % 2 == 0 && panorama.height % 2 == 0)
        return build(halved(panorama), choose);
    Blurs blurs;
    CubeChain& chain = blurs.chain;
    chain.allocate(log2_size, log2_size);
    const int size = chain.face_size(0);
    const std::vector<TexelPoint> points = texel_points(panorama.width, size);
    const Peaks peaks = find_peaks(panorama);
    chain.scale = chain_scale(peaks.brightest);
    resample({&panorama, peaks.limit, points}, all_of(size), chain);
    for (int level = 1; level < chain.levels; ++level)
        blur_level(level, chain);
    if (!peaks.peaks.empty()) {
        blurs.lamps = choose(peaks, chain);
        const int end = std::min(blurs.lamps.last_level + 1, chain.levels);
        tbb::parallel_for(1, std::max(end, 1), [&](int level) { add_peaks(peaks, level, chain); });
        resample_peaks(panorama, peaks, chain);
    }
    return blurs;
}

} // namespace

CubeChain resampled(const Panorama& panorama, int log2_size)
{
    // A panorama of many texels per face texel is halved first.
    if (panorama.width > (16 << log2_size) && panorama.width % 2 == 0 && panorama.height % 2 == 0)
        return resampled(halved(panorama), log2_size);
    const Peaks peaks = find_peaks(panorama);
    CubeChain chain;
    chain.allocate(log2_size, 1);
    chain.scale = chain_scale(peaks.brightest);
    resample({&panorama, brightest_of_all, texel_points(panorama.width, chain.face_size(0), 1.0)},
             all_of(chain.face_size(0)), chain);
    resample_peaks(panorama, peaks, chain);
    return chain;
}

Blurs make_blurs(const Panorama& panorama)
{
    return build(panorama, choose_lamps);
}

CubeChain make_chain(const Panorama& panorama)
{
    return build(panorama,
                 [](const Peaks&, const CubeChain& chain) {
                     return Lamps{{}, chain.levels};
                 })
        .chain;
}

} // namespace lambent::environment
