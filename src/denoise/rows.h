// Rows of planes that the filter's stages pass on: what they hold, and how the kernels get them.
#pragma once

#include <tbb/cache_aligned_allocator.h>

#include <array>
#include <cstddef>
#include <vector>

namespace lambent::denoise {

// Planes of each kind of row.
enum GuidePlane : int {
    normal_plane = 0, // and two more
    depth_plane = 3,
    slope_x_plane, // metres per pixel to the right
    slope_y_plane, // and downwards
    roughness_plane,
    metalness_plane,
    power_plane,   // of the cosine between normals
    covered_plane, // 1 or 0
    guide_planes
};

// Weighed sums over pixels; the quotient of a sum and its weight is light over albedo. Three planes each.
enum SumPlane : int {
    sum_unshadowed = 0, // of the first half; of the second six further
    sum_change = 3,     // found minus unshadowed; likewise
    sum_weight = 12,    // one plane, or three where the albedo has three
    most_sum_planes = 15
};

// What is known of a pixel without filtering.
enum GivenPlane : int {
    given_exact = 0,
    given_albedo = 3,
    given_weight = 6, // samples times coverage
    given_share,      // of exact light that is a control variate
    given_planes
};

constexpr int level_count = 5;                   // unfiltered, and four levels of the a-trous filter
constexpr int candidate_count = 2 * level_count; // control variate, then ratio, of each level
constexpr int level_step(int level)
{
    return 1 << (level - 1);
}

// Candidates for what errors are measured against: control variates of levels 0 and 1, ratio of level 1.
constexpr int target_count = 3;

// How alike a pixel and its neighbours are, 1, 2 and 4 pixels away in four directions (a plane each); those in the other
// directions have the pixel as such a neighbour.
constexpr int pool_count = 3, direction_count = 4;
constexpr int direction_x[direction_count] = {1, -1, 0, 1}, direction_y[direction_count] = {0, 1, 1, 1};
constexpr int likeness_planes = pool_count * direction_count;

enum ResultPlane : int { result_light = 0, result_gap = 3, result_planes = 6 };

// Columns on either side of a row that stay 0: what the widest filter reaches over, and whole vectors.
constexpr int row_margin = 32;

// The latest rows of some planes. Rows are found by the picture's y, which may be negative.
class RowRing {
public:
    RowRing(int rows, int planes, std::ptrdiff_t pitch)
        : rows_(rows), planes_(planes), pitch_(pitch),
          values_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(planes) *
                  static_cast<std::size_t>(pitch))
    {
    }

    /// Column 0 of the first plane of row y; the next plane is a pitch further.
    float* row(int y) { return values_.data() + offset(y); }
    const float* row(int y) const { return values_.data() + offset(y); }
    void clear_row(int y);

private:
    std::ptrdiff_t offset(int y) const
    {
        const int at = y % rows_;
        return static_cast<std::ptrdiff_t>(at < 0 ? at + rows_ : at) * planes_ * pitch_ + row_margin;
    }

    int rows_, planes_;
    std::ptrdiff_t pitch_;
    std::vector<float, tbb::cache_aligned_allocator<float>>
        values_; // vectors that lie across lines load slowly
};

/// One row of an a-trous level: 5x5 binomial weights times those of the guides, in which `lobe` takes the power from the
/// guides. `planes` is 13 or 15 (SumPlane). Rows are of those `step` apart, the middle one that of the result.
struct SmoothRow {
    std::array<const float*, 5> guides, from;
    float* to;
    int step, planes;
    bool lobe;
    int columns;
    std::ptrdiff_t pitch; ///< floats between planes
};
void smooth_row(const SmoothRow& row);

/// Fills the likeness planes of row 0 of `guides`, which has those below, up to the fourth.
struct LikenessRow {
    std::array<const float*, 5> guides;
    float* to;
    int columns;
    std::ptrdiff_t pitch;
};
void compare_neighbours(const LikenessRow& row);

/// A row of 3x3 neighbourhoods at one of the steps 1 << pool.
struct Neighbourhood {
    std::array<const float*, 3> from;     ///< what is pooled, rows a step apart
    std::array<const float*, 2> likeness; ///< rows a step above, and of the pixels
    const float* guides;
    int pool, columns;
    std::ptrdiff_t pitch;
};

/// Pools 3 or 10 planes of errors over 3x3 pixels.
void pool_row(const Neighbourhood& near, int planes, float* to);

/// The index of the plane that is least at each pixel, as a float; -1 where nothing is covered.
struct ChoiceRow {
    const float *errors, *guides;
    int planes, columns;
    std::ptrdiff_t pitch;
};
void choose_row(const ChoiceRow& row, float* choices);

/// The sums of all levels at one row, and what is known of it.
struct CandidateRow {
    std::array<const float*, level_count> sums;
    const float *given, *guides;
    int columns;
    std::ptrdiff_t pitch;
    int weight_planes; ///< 1 or 3
    float cut, ratio_limit;
};

/// Squared errors of the target's candidates against the other half's unfiltered light. Levels above 1 are not read.
void find_target_errors(const CandidateRow& row, float* errors);

/// Squared errors of every candidate against the other half's target, whose index per pixel is in `targets`.
void find_errors(const CandidateRow& row, const float* targets, float* errors);

/// Filtered light and gap (ResultPlane): candidates in the shares in which the 3x3 choices around a pixel name them.
/// `near.from` are rows of choices, its pool the first.
void blend_row(const CandidateRow& row, const Neighbourhood& near, float* to);

} // namespace lambent::denoise
