#include "compare/flip_tile.h"

#include "compare/flip_color.h"
#include "compare/flip_exposures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace lambent::compare {
namespace {

constexpr float q_f = 0.5f; // section 4.2.2

using Row = std::vector<float>;

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

// Planes filtered along rows, to be filtered along columns.
enum Plane { achromatic, red_green, blue_yellow_0, blue_yellow_1, smooth, edge, point, plane_count };

// A tile of one image filtered by FLIP's colour and feature pipelines, row by row.
class FilteredTile {
public:
    FilteredTile(const image::RadianceImage& picture, const FlipFilters& filters, const Shown& shown,
                 const Tile& tile);

    // Computes the following members for a row of the tile.
    void find_row(int y);
    Row lightness, a, b; // Hunt-adjusted L*a*b* after the contrast filters
    Row edges, points;   // strength of features

private:
    void read_row(const image::RadianceImage& picture, const Shown& shown, int y);
    void filter_row(int y);
    void down(Plane plane, const Filter& filter, float share, Row& out) const;
    float* row(Plane plane, int y) { return planes_[plane].data() + index(y) * index(tile_.width); }
    const float* row(Plane plane, int y) const
    {
        return planes_[plane].data() + index(y) * index(tile_.width);
    }

    const FlipFilters& filters_;
    Tile tile_;
    int border_;                   // pixels around the tile that the filters reach
    Row light_, reddish_, bluish_; // a row of Y, X - Y and Y - Z with its border
    std::array<Row, plane_count> planes_;
    int y_ = 0; // of find_row, in rows of the planes
    Row first_, second_;
};

// Applies a filter at `count` pixels of a row: out += share * (weights times values). `values(offset)` points to the
// values at that offset from the pixels. Weights at the same distance are applied together, which halves the products
// and makes the result exactly 0 for uniform light where weights add up to 0: FLIP takes a square root of it.
template <class Values>
void add_filtered(const Filter& filter, float share, int count, const Values& values, float* __restrict out)
{
    const auto weight = [&](int k) { return share * filter.weights[index(k + filter.radius)]; };
    const float* middle = values(0);
    if (filter.shape == Shape::even)
        for (int x = 0; x < count; ++x)
            out[x] += weight(0) * middle[x];
    for (int k = 1; k <= filter.radius; ++k) {
        // A convolution: the weight of offset k meets the value at -k.
        const float w = weight(k);
        const float *before = values(-k), *after = values(k);
        if (filter.shape == Shape::even)
            for (int x = 0; x < count; ++x)
                out[x] += w * (before[x] + after[x]);
        else if (filter.shape == Shape::odd)
            for (int x = 0; x < count; ++x)
                out[x] += w * (before[x] - after[x]);
        else
            for (int x = 0; x < count; ++x)
                out[x] += w * ((before[x] - middle[x]) + (after[x] - middle[x]));
    }
}

Color displayed(const float* rgb, const Shown& shown)
{
    if (shown.codes)
        return {decoded(rgb[0]), decoded(rgb[1]), decoded(rgb[2])};
    return {tone_mapped(rgb[0] * shown.factor), tone_mapped(rgb[1] * shown.factor),
            tone_mapped(rgb[2] * shown.factor)};
}

FilteredTile::FilteredTile(const image::RadianceImage& picture, const FlipFilters& filters,
                           const Shown& shown, const Tile& tile)
    : filters_(filters), tile_(tile), border_(filters.radius)
{
    for (Row* row : {&lightness, &a, &b, &edges, &points, &first_, &second_})
        row->resize(index(tile.width));
    for (Row* row : {&light_, &reddish_, &bluish_})
        row->resize(index(tile.width + 2 * border_));
    for (Row& plane : planes_)
        plane.resize(index(tile.width) * index(tile.height + 2 * border_));
    for (int y = 0; y < tile.height + 2 * border_; ++y) {
        read_row(picture, shown, std::clamp(tile.top + y - border_, 0, picture.height - 1));
        filter_row(y);
    }
}

// The paper's Y, Cx and Cz are these, scaled and shifted; filters whose weights add up to 1 commute with that.
void FilteredTile::read_row(const image::RadianceImage& picture, const Shown& shown, int y)
{
    for (int i = 0; i < tile_.width + 2 * border_; ++i) {
        const int x = std::clamp(tile_.left + i - border_, 0, picture.width - 1);
        const Color xyz = transformed(rgb_to_xyz, displayed(picture.pixel(x, y), shown));
        light_[index(i)] = xyz.y;
        reddish_[index(i)] = xyz.x - xyz.y;
        bluish_[index(i)] = xyz.y - xyz.z;
    }
}

void FilteredTile::filter_row(int y)
{
    const auto put = [&](Plane plane, const Row& in, const Filter& filter) {
        float* out = row(plane, y);
        std::fill_n(out, tile_.width, 0.0f);
        add_filtered(
            filter, 1.0f, tile_.width, [&](int k) { return in.data() + border_ + k; }, out);
    };
    put(achromatic, light_, filters_.achromatic);
    put(red_green, reddish_, filters_.red_green);
    put(blue_yellow_0, bluish_, filters_.blue_yellow[0]);
    put(blue_yellow_1, bluish_, filters_.blue_yellow[1]);
    put(smooth, light_, filters_.smooth);
    put(edge, light_, filters_.edge);
    put(point, light_, filters_.point);
}

// out += share * the plane filtered along columns at the row y_.
void FilteredTile::down(Plane plane, const Filter& filter, float share, Row& out) const
{
    add_filtered(
        filter, share, tile_.width, [&](int k) { return row(plane, y_ + k); }, out.data());
}

void FilteredTile::find_row(int y)
{
    y_ = y + border_;
    const auto both_ways = [&](Plane across, Plane along_rows, const Filter& filter, Row& strength) {
        std::fill(first_.begin(), first_.end(), 0.0f);
        std::fill(second_.begin(), second_.end(), 0.0f);
        down(across, filters_.smooth, 1.0f, first_);
        down(along_rows, filter, 1.0f, second_);
        for (std::size_t x = 0; x < strength.size(); ++x)
            strength[x] = std::sqrt(first_[x] * first_[x] + second_[x] * second_[x]);
    };
    both_ways(edge, smooth, filters_.edge, edges);
    both_ways(point, smooth, filters_.point, points);

    for (Row* sum : {&lightness, &a, &b})
        std::fill(sum->begin(), sum->end(), 0.0f);
    down(achromatic, filters_.achromatic, 1.0f, lightness);
    down(red_green, filters_.red_green, 1.0f, a);
    down(blue_yellow_0, filters_.blue_yellow[0], filters_.blue_yellow_share[0], b);
    down(blue_yellow_1, filters_.blue_yellow[1], filters_.blue_yellow_share[1], b);
    for (std::size_t x = 0; x < lightness.size(); ++x) {
        Color rgb = transformed(xyz_to_rgb, {lightness[x] + a[x], lightness[x], lightness[x] - b[x]});
        // Colours outside a display's range are clamped to it (section 4.1.2).
        rgb = {std::clamp(rgb.x, 0.0f, 1.0f), std::clamp(rgb.y, 0.0f, 1.0f), std::clamp(rgb.z, 0.0f, 1.0f)};
        const Color lab = hunt_lab(transformed(rgb_to_xyz, rgb));
        lightness[x] = lab.x;
        a[x] = lab.y;
        b[x] = lab.z;
    }
}

// Sections 4.2.2 and 4.3: where features differ, colours count for more.
float flip_error(const FilteredTile& p, const FilteredTile& q, std::size_t x)
{
    const float color = color_error(hyab({p.lightness[x], p.a[x], p.b[x]}, {q.lightness[x], q.a[x], q.b[x]}));
    const float feature = std::max(std::fabs(p.edges[x] - q.edges[x]), std::fabs(p.points[x] - q.points[x]));
    constexpr float scale = static_cast<float>(1.0 / std::numbers::sqrt2);
    static_assert(q_f == 0.5f, "the power below is a square root");
    const float feature_error = std::sqrt(scale * feature);
    return color > 0.0f ? std::pow(color, 1.0f - std::min(feature_error, 1.0f)) : 0.0f;
}

} // namespace

void flip_tile(const Pair& pair, const FlipFilters& filters, const Shown& shown, const Tile& tile,
               ErrorMap& map)
{
    FilteredTile picture(pair.picture, filters, shown, tile), reference(pair.reference, filters, shown, tile);
    for (int y = 0; y < tile.height; ++y) {
        picture.find_row(y);
        reference.find_row(y);
        float* out = map.values.data() + index(tile.top + y) * index(map.width) + tile.left;
        for (int x = 0; x < tile.width; ++x)
            out[x] = std::max(out[x], flip_error(picture, reference, index(x)));
    }
}

} // namespace lambent::compare
