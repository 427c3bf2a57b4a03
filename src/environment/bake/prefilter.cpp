#include "environment/bake/prefilter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

// Extent, times the lobe's alpha, of cells at the horizon: the cosine's kink there cannot be corrected by a curvature,
// so cells must be small, the more so the wider the lobe.
constexpr double horizon_extent = 0.05;

// At a lobe's centre, where the distance is no bound, the extent of cells is this share of its alpha over the fineness.
constexpr double core = 0.65;

// Extent of a tree's finest cells as such a share, which bright cells need.
constexpr double finest = 0.4;

// Cells with more than this share of all light must be finer by this factor.
constexpr double much_share = 0.002, much_light_times = 4.0;

// Cells of more than this multiple of the mean radiance are summed separately.
constexpr double bright_times = 2.0;

// The sum of the channels, by which cells are compared.
float light_of(const LightCell& cell)
{
    return cell.r + cell.g + cell.b;
}

} // namespace

double PrefilterLobe::weight(double cosine) const
{
    if (!(cosine > 0.0))
        return 0.0;
    if (phong)
        return std::pow(cosine, exponent);
    const double q = alpha * alpha + (1.0 - alpha * alpha) * 0.5 * (1.0 - cosine);
    return cosine / (q * q);
}

// GGX: q runs from alpha^2 to (1 + alpha^2) / 2, and cosine / q^2 is a sum of powers of q.
double PrefilterLobe::integral() const
{
    if (phong)
        return 2.0 * std::numbers::pi / (exponent + 1.0);
    const double a2 = alpha * alpha, k = 2.0 / std::max(1.0 - a2, 1e-9);
    if (k > 1e5)
        return std::numbers::pi;
    const double last = 0.5 * (1.0 + a2);
    return 2.0 * std::numbers::pi * k * ((1.0 + a2 * k) * (1.0 / a2 - 1.0 / last) - k * std::log(last / a2));
}

PrefilterLobe ggx_lobe(double alpha)
{
    return {false, 1.0, alpha};
}

PrefilterLobe phong_lobe(double exponent)
{
    return {true, exponent, std::sqrt(2.0 / (exponent + 2.0))};
}

double finest_extent(const PrefilterLobe& lobe, double fineness)
{
    return finest * lobe.alpha / fineness;
}

// A cone that encloses the directions of a patch or of a part of it.
struct Prefilter::Cap {
    float x = 0.0f, y = 0.0f, z = 0.0f; // axis
    float radius = 0.0f;                // as a chord

    Cap(const PrefilterPatch& patch, std::size_t first, std::size_t count)
    {
        for (std::size_t i = first; i < first + count; ++i)
            x += patch.x[i], y += patch.y[i], z += patch.z[i];
        const float over = 1.0f / std::max(std::sqrt(x * x + y * y + z * z), 1e-6f);
        x *= over, y *= over, z *= over;
        for (std::size_t i = first; i < first + count; ++i)
            radius = std::max(radius, square_chord(patch.x[i], patch.y[i], patch.z[i]));
        radius = std::sqrt(radius);
    }

    float square_chord(float px, float py, float pz) const
    {
        const float dx = px - x, dy = py - y, dz = pz - z;
        return dx * dx + dy * dy + dz * dz;
    }
};

// Traverses the tree for cells that together represent all light a cap receives.
class Prefilter::Walk {
public:
    Walk(const Prefilter& prefilter, const Cap& cap, Scratch& scratch, std::vector<Scratch::CellIndex>* left)
        : prefilter_(prefilter), cap_(cap), scratch_(scratch), left_(left)
    {
    }

    void visit(int depth, int column, int row);

private:
    void take(const LightCell& cell, int depth, int column, int row);
    static bool beyond(float square, float chord) { return chord < 0.0f || square > chord * chord; }

    const Prefilter& prefilter_;
    const Cap& cap_;
    Scratch& scratch_;
    std::vector<Scratch::CellIndex>* left_; // cells left to the parts of the cap; null: none may be left
};

void Prefilter::Walk::take(const LightCell& cell, int depth, int column, int row)
{
    const bool own = cell.area > 0.0f;
    const LightCell& area = own ? cell : prefilter_.tree_.area(static_cast<std::size_t>(depth), column, row);
    std::vector<LightCell>& cells =
        light_of(cell) > prefilter_.bright_radiance_ * area.area ? scratch_.bright : scratch_.dim;
    cells.push_back(cell);
    if (!own)
        cells.push_back(area);
}

void Prefilter::Walk::visit(int depth, int column, int row)
{
    constexpr float horizon = std::numbers::sqrt2_v<float>;
    const Bounds bounds = prefilter_.bounds_[static_cast<std::size_t>(depth)][static_cast<std::size_t>(row)];
    const LightCell cell = prefilter_.tree_.cell(static_cast<std::size_t>(depth), column, row);
    const float square = cap_.square_chord(cell.x, cell.y, cell.z);
    const float reach = cap_.radius + bounds.reach;
    if (beyond(square, horizon + reach))
        return;
    const float far = light_of(cell) > prefilter_.much_light_ ? bounds.far_bright : bounds.far;
    const bool at_horizon = !bounds.fine_at_horizon && beyond(square, horizon - reach);
    if (depth == 0 || (!at_horizon && beyond(square, far < 0.0f ? -1.0f : far + cap_.radius))) {
        take(cell, depth, column, row);
        return;
    }
    // The cell may be fine enough for some parts of the cap: each part decides for itself.
    const float sure = bounds.reach - cap_.radius;
    const bool all_at_horizon =
        at_horizon && sure > 0.0f && beyond(square, horizon - sure) && !beyond(square, horizon + sure);
    if (left_ && !all_at_horizon && beyond(square, far - cap_.radius)) {
        left_->push_back({depth, column, row});
        return;
    }
    const LightCellLevel& next = prefilter_.tree_.levels()[static_cast<std::size_t>(depth - 1)];
    for (int j = 2 * row; j < std::min(2 * row + 2, next.height); ++j)
        for (int i = 2 * column; i < std::min(2 * column + 2, next.width); ++i)
            visit(depth - 1, i, j);
}

Prefilter::Prefilter(const LightTree& tree, const PrefilterLobe& lobe, double fineness)
    : tree_(tree), lobe_(lobe)
{
    double light = 0.0;
    const LightCellLevel& top = tree.levels().back();
    for (int row = 0; row < top.height; ++row)
        for (int column = 0; column < top.width; ++column)
            light += static_cast<double>(light_of(tree.cell(tree.levels().size() - 1, column, row)));
    much_light_ = static_cast<float>(much_share * light);
    bright_radiance_ = static_cast<float>(bright_times * light / (4.0 * std::numbers::pi));
    const double core2 = core * core * lobe.alpha * lobe.alpha, at_horizon = horizon_extent / lobe.alpha;
    for (const LightCellLevel& level : tree.levels()) {
        std::vector<Bounds>& rows = bounds_.emplace_back();
        for (float width : level.extent) {
            const double extent = static_cast<double>(width);
            const auto far = [&](double times) {
                const double distance2 = extent * extent * fineness * fineness * times * times - core2;
                return static_cast<float>(distance2 > 0.0 ? std::sqrt(distance2) + 0.7 * extent : -1.0);
            };
            rows.push_back(
                {far(1.0), far(much_light_times), static_cast<float>(1.42 * extent), extent <= at_horizon});
        }
    }
}

void Prefilter::fill(PrefilterPatch& patch, Scratch& scratch) const
{
    for (PrefilterPatch::Sums* sums : {&patch.dim, &patch.bright})
        for (float* column : {sums->r, sums->g, sums->b, sums->weight})
            std::fill_n(column, PrefilterPatch::tile * patch.tiles, 0.0f);
    std::vector<Scratch::CellIndex>& all = scratch.left[0];
    all.clear();
    const int top = static_cast<int>(tree_.levels().size()) - 1;
    for (int row = 0; row < tree_.levels().back().height; ++row)
        for (int column = 0; column < tree_.levels().back().width; ++column)
            all.push_back({top, column, row});
    fill(patch, {0, patch.tiles, 0}, scratch);
    finish_texels(patch, lobe_.integral());
}

// Cells fine enough for all of a part are added to all of it at once; the others are left to its quarters.
void Prefilter::fill(PrefilterPatch& patch, const Part& part, Scratch& scratch) const
{
    constexpr std::size_t tile = PrefilterPatch::tile;
    const bool whole = part.tiles == 1;
    const Cap cap(patch, tile * part.first, tile * part.tiles);
    std::vector<Scratch::CellIndex>& left = scratch.left[part.depth + 1];
    left.clear();
    scratch.dim.clear();
    scratch.bright.clear();
    Walk walk(*this, cap, scratch, whole ? nullptr : &left);
    for (const Scratch::CellIndex& index : scratch.left[part.depth])
        walk.visit(index.depth, index.column, index.row);
    add_cells(scratch.dim, lobe_, {patch, patch.dim, tile * part.first, tile * part.tiles});
    add_cells(scratch.bright, lobe_, {patch, patch.bright, tile * part.first, tile * part.tiles});
    if (whole || left.empty())
        return;
    const std::size_t quarter = std::max(part.tiles / 4, std::size_t{1});
    for (std::size_t first = part.first; first < part.first + part.tiles; first += quarter)
        fill(patch, {first, std::min(quarter, part.first + part.tiles - first), part.depth + 1}, scratch);
}

} // namespace lambent::environment
