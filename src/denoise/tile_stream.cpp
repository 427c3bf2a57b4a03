#include "denoise/tile_stream.h"

#include "denoise/prepare_rows.h"
#include "denoise/rows.h"

#include <algorithm>
#include <array>

namespace lambent::denoise {

void RowRing::clear_row(int y)
{
    float* const first = row(y) - row_margin;
    std::fill(first, first + planes_ * pitch_, 0.0f);
}

namespace {

// Rows that a stage is behind the row that is read: each waits for the rows below that it reaches.
constexpr int slope_lag = 1;
constexpr std::array<int, level_count> level_lag = {0, 3, 7, 15, 31};
constexpr int likeness_lag = 5;
constexpr int target_error_lag = 6, target_lag = 13; // and its pools between them
constexpr int error_lag = 31, choice_lag = 38;
constexpr int blend_lag = 39;
constexpr int apron = blend_lag + 1; // pixels around a tile that its result depends on

// Rows that the last stage which reads them still needs.
constexpr std::array<int, level_count> level_rows = {40, 37, 33, 33, 9};
constexpr int guide_rows = 48, likeness_rows = 38, target_rows = 20;

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

// Whole vectors and their margins; not a multiple of 256 bytes, for planes at such distances share few lines of a cache.
std::ptrdiff_t pitch_of(int columns)
{
    const int whole = (columns + 15) / 16 * 16 + 2 * row_margin;
    return whole % 64 == 0 ? whole + 16 : whole;
}

class TileStream {
public:
    TileStream(const LightJob& job, const Tile& tile);
    void run();

private:
    bool is_inside(int y) const { return y >= 0 && y < job_.picture.height; }
    // Whether a stage has to compute row y, `lag` rows behind; rows further up are of no use to the tile.
    bool is_needed(int y, int lag) const { return y >= tile_.y0 - (blend_lag - lag); }
    RowSpan span(int y) const { return {y, first_, columns_, pitch_}; }

    void prepare(int y);
    void find_slopes(int y);
    void smooth(int level, int y);
    void compare(int y);
    void find_target_error(int y);
    void find_error(int y);
    void blend(int y);
    void write(int y);
    CandidateRow candidates(int y) const;
    Neighbourhood neighbourhood(const RowRing& from, int y, int pool) const;

    // Errors of candidates on their way to a choice: pooled three times, each over twice the distance.
    struct Choice {
        RowRing errors, pooled_once, pooled_twice, pooled, choices;
        int planes, lag; // of the result
    };
    Choice make_choice(int planes, int lag, int rows) const;
    void pool(const RowRing& from, RowRing& to, int y, int pool, const Choice& choice);
    void choose(Choice& choice, int frontier);

    const LightJob& job_;
    Tile tile_;
    int first_, columns_; // of the tile with its apron
    std::ptrdiff_t pitch_;
    int weight_planes_;
    RowRing guides_, given_, likeness_;
    std::array<RowRing, level_count> sums_;
    Choice target_, choice_;
    RowRing result_;
};

TileStream::TileStream(const LightJob& job, const Tile& tile)
    : job_(job), tile_(tile), first_(std::max(tile.x0 - apron, 0)),
      columns_(std::min(tile.x1 + apron, job.picture.width) - first_), pitch_(pitch_of(columns_)),
      weight_planes_(job.light.albedo[0].empty() ? 1 : 3), guides_(guide_rows, guide_planes, pitch_),
      given_(level_rows[0], given_planes, pitch_), likeness_(likeness_rows, likeness_planes, pitch_),
      sums_{RowRing{level_rows[0], sum_weight + weight_planes_, pitch_},
            RowRing{level_rows[1], sum_weight + weight_planes_, pitch_},
            RowRing{level_rows[2], sum_weight + weight_planes_, pitch_},
            RowRing{level_rows[3], sum_weight + weight_planes_, pitch_},
            RowRing{level_rows[4], sum_weight + weight_planes_, pitch_}},
      target_(make_choice(target_count, target_lag, target_rows)),
      choice_(make_choice(candidate_count, choice_lag, 3)), result_(1, result_planes, pitch_)
{
}

void TileStream::run()
{
    for (int y = tile_.y0 - apron; y < tile_.y1 + blend_lag; ++y) {
        prepare(y);
        find_slopes(y - slope_lag);
        for (int level = 1; level < level_count; ++level)
            smooth(level, y - level_lag[at(level)]);
        compare(y - likeness_lag);
        find_target_error(y - target_error_lag);
        choose(target_, y);
        find_error(y - error_lag);
        choose(choice_, y);
        blend(y - blend_lag);
    }
}

TileStream::Choice TileStream::make_choice(int planes, int lag, int rows) const
{
    return {{3, planes, pitch_},
            {5, planes, pitch_},
            {9, planes, pitch_},
            {1, planes, pitch_},
            {rows, 1, pitch_},
            planes,
            lag};
}

void TileStream::prepare(int y)
{
    if (!is_inside(y)) {
        guides_.clear_row(y);
        given_.clear_row(y);
        sums_[0].clear_row(y);
        return;
    }
    prepare_guides(job_.picture.guides, job_.picture.width, span(y), guides_.row(y));
    prepare_light(job_, span(y), {given_.row(y), sums_[0].row(y)});
}

void TileStream::find_slopes(int y)
{
    if (is_inside(y) && is_needed(y, slope_lag))
        prepare_slopes(guides_.row(y - 1), guides_.row(y), guides_.row(y + 1), span(y));
}

void TileStream::smooth(int level, int y)
{
    if (!is_needed(y, level_lag[at(level)]))
        return;
    RowRing& to = sums_[at(level)];
    if (!is_inside(y)) {
        to.clear_row(y);
        return;
    }
    const int step = level_step(level);
    SmoothRow row{{}, {}, to.row(y), step, sum_weight + weight_planes_, job_.lobe, columns_, pitch_};
    for (int j = 0; j < 5; ++j) {
        row.guides[at(j)] = guides_.row(y + (j - 2) * step);
        row.from[at(j)] = sums_[at(level - 1)].row(y + (j - 2) * step);
    }
    smooth_row(row);
}

void TileStream::compare(int y)
{
    if (!is_needed(y, likeness_lag))
        return;
    if (!is_inside(y)) {
        likeness_.clear_row(y);
        return;
    }
    LikenessRow row{{}, likeness_.row(y), columns_, pitch_};
    for (int j = 0; j < 5; ++j)
        row.guides[at(j)] = guides_.row(y + j);
    compare_neighbours(row);
}

CandidateRow TileStream::candidates(int y) const
{
    CandidateRow row{{},     given_.row(y),  guides_.row(y),    columns_,
                     pitch_, weight_planes_, job_.settings.cut, job_.settings.ratio_limit};
    for (int level = 0; level < level_count; ++level)
        row.sums[at(level)] = sums_[at(level)].row(y);
    return row;
}

Neighbourhood TileStream::neighbourhood(const RowRing& from, int y, int pool) const
{
    const int step = 1 << pool;
    return {{from.row(y - step), from.row(y), from.row(y + step)},
            {likeness_.row(y - step), likeness_.row(y)},
            guides_.row(y),
            pool,
            columns_,
            pitch_};
}

void TileStream::find_target_error(int y)
{
    if (!is_needed(y, target_error_lag))
        return;
    if (is_inside(y))
        find_target_errors(candidates(y), target_.errors.row(y));
    else
        target_.errors.clear_row(y);
}

void TileStream::find_error(int y)
{
    if (!is_needed(y, error_lag))
        return;
    if (is_inside(y))
        find_errors(candidates(y), target_.choices.row(y), choice_.errors.row(y));
    else
        choice_.errors.clear_row(y);
}

void TileStream::pool(const RowRing& from, RowRing& to, int y, int pool, const Choice& choice)
{
    if (is_inside(y))
        pool_row(neighbourhood(from, y, pool), choice.planes, to.row(y));
    else
        to.clear_row(y);
}

void TileStream::choose(Choice& choice, int frontier)
{
    const int y = frontier - choice.lag;
    if (!is_needed(y + 6, choice.lag - 6))
        return;
    pool(choice.errors, choice.pooled_once, y + 6, 0, choice);
    pool(choice.pooled_once, choice.pooled_twice, y + 4, 1, choice);
    pool(choice.pooled_twice, choice.pooled, y, 2, choice);
    if (is_inside(y))
        choose_row({choice.pooled.row(y), guides_.row(y), choice.planes, columns_, pitch_},
                   choice.choices.row(y));
    else
        choice.choices.clear_row(y);
}

void TileStream::blend(int y)
{
    if (y < tile_.y0)
        return;
    blend_row(candidates(y), neighbourhood(choice_.choices, y, 0), result_.row(0));
    write(y);
}

void TileStream::write(int y)
{
    const float* const from = result_.row(0) + (tile_.x0 - first_);
    FilteredRow row{tile_.x0, y, tile_.x1 - tile_.x0, job_.lobe, {}, {}};
    for (int c = 0; c < 3; ++c) {
        row.light[at(c)] = from + (result_light + c) * pitch_;
        row.gap[at(c)] = from + (result_gap + c) * pitch_;
    }
    job_.take(row);
}

} // namespace

void filter_tile(const LightJob& job, const Tile& tile)
{
    TileStream(job, tile).run();
}

} // namespace lambent::denoise
