// What the statistical filter knows of each pixel, in planes with a margin, and its two kernels.
#pragma once

#include "denoise/statistical_filter.h"

#include <cstddef>
#include <vector>

namespace lambent::denoise {

/// Planes of StatisticalPlanes. Where a pixel takes no part, or lies outside of the picture, `usable` is 0 and variances
/// are 1, so that no quotient is NaN.
enum StatisticalPlane : int {
    usable_plane = 0,       // 1 or 0
    reflected_plane,        // light without what is emitted, over albedo: three
    own_variance_plane = 4, // of these, as estimated; 0 if unknown: three
    variance_plane = 7,     // the same pooled with the neighbours', above 0: three
    freedom_plane = 10,     // degrees of freedom of the own variance; 0: unknown
    inverse_plane,          // one over those of the pooled variance
    weight_plane,           // what the pixel counts in averages
    albedo_plane,           // by which light was divided, above 0: three
    coverage_plane = 16,    // share of the samples that met what reflects, above 0
    surface_plane = 17,     // normal, depth in metres, its slope per pixel to the right and downwards: six
    statistical_planes = 23
};
constexpr int surface_depth = 3, surface_slope_x = 4, surface_slope_y = 5;

/// The filter averages pixels up to this many columns and rows apart.
constexpr int filter_reach = 7;

class StatisticalPlanes {
public:
    StatisticalPlanes(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    std::ptrdiff_t pitch() const { return pitch_; }

    /// Pixel (x, y) of a plane; either may be up to `margin` outside of the picture, x further to the right.
    float* at(int plane, int x, int y) { return values_.data() + offset(plane, x, y); }
    const float* at(int plane, int x, int y) const { return values_.data() + offset(plane, x, y); }

    static constexpr int margin = filter_reach + 2;

private:
    std::ptrdiff_t offset(int plane, int x, int y) const
    {
        return (static_cast<std::ptrdiff_t>(plane) * rows_ + y + margin) * pitch_ + x + margin;
    }

    int width_, height_;
    std::ptrdiff_t pitch_, rows_;
    std::vector<float> values_;
};

/// Fills all planes but those of the pooled variance, its freedom and the weight.
void fill(const NoisyPicture& picture, StatisticalPlanes& planes);

/// Fills these at row y.
void pool_variance(StatisticalPlanes& planes, int y);

/// Part of a picture, at most so large.
struct FilterTile {
    static constexpr int most_columns = 128, most_rows = 16;
    int x, y, columns, rows;
};

/// Filtered light over albedo, and the share of each pixel's own light in it, without margin.
struct Averages {
    Rgb light;
    Plane own_share;
};

void average_tile(const StatisticalPlanes& planes, const FilterTile& tile, Averages& to);

} // namespace lambent::denoise
