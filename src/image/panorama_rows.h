// Positions of the rows and columns of equirectangular images.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace lambent::image {

/// Polar angle in radians from +Y of each of `height` rows (at least 1), between which lookups interpolate linearly,
/// across the poles too. The angles are such that each row contributes the light of its texels: radiance times solid
/// angle. They are the centres of the rows except near the poles: at its centre the first row would contribute 13/12 of
/// its light, and it lies a fourteenth of a row closer to the pole.
std::vector<double> row_angles(int height);

/// Solid angle of each texel of row y in steradians, exact instead of by the sine at its centre.
double texel_solid_angle(int width, int height, int y);

/// Azimuth in radians, from +X towards +Z, at x columns from the left edge.
inline double column_azimuth(double x, int width)
{
    return (x / width - 0.5) * 2.0 * std::numbers::pi;
}

/// Two neighbouring rows or columns and the weight of the second; the first has the weight 1 - share.
struct Neighbours {
    int first, second;
    double share;
};

/// Finds the rows of an image around a position; the rows lie at row_angles().
class PanoramaRows {
public:
    explicit PanoramaRows(int height);

    /// The rows on either side of v (0 to 1). They range from -1 to the height.
    Neighbours around(double v) const
    {
        // Each row lies less than half a row from its centre.
        int first = std::clamp(static_cast<int>(std::floor(v * height_ - 0.5)), -1, height_ - 1);
        if (first < height_ - 1 && v >= position(first + 1))
            ++first;
        else if (first >= 0 && v < position(first))
            --first;
        return {first, first + 1, (v - position(first)) / (position(first + 1) - position(first))};
    }

private:
    double position(int row) const { return positions_[static_cast<std::size_t>(row + 1)]; }

    int height_;
    std::vector<double> positions_; // v of each row, with one row beyond each pole
};

} // namespace lambent::image
