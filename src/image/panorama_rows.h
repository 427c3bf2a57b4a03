// Where the rows and columns of an equirectangular picture are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace lambent::image {

/// For each of `height` rows (at least 1) the polar angle in radians, from +Y down, at which it holds. Between them a picture
/// is read linearly, across the poles too. Read so, each row gives the light of its texels: radiance times their solid angle.
/// They are the middles of the rows but next to the poles, where those would give a first row 13/12 of its light and this is a
/// fourteenth of a row closer to the pole.
std::vector<double> row_angles(int height);

/// Solid angle of each texel of row y of a panorama, in steradians: exact, not the sine at its centre.
double texel_solid_angle(int width, int height, int y);

/// Azimuth in radians, from +X towards +Z, of a place x columns from the left edge.
inline double column_azimuth(double x, int width)
{
    return (x / width - 0.5) * 2.0 * std::numbers::pi;
}

/// Two neighbouring rows or columns, and how much the second counts; the first counts the rest.
struct Neighbours {
    int first, second;
    double share;
};

/// The rows of a picture at row_angles().
class PanoramaRows {
public:
    explicit PanoramaRows(int height);

    /// The rows on either side of v, 0 to 1: from -1 to the height.
    Neighbours around(double v) const
    {
        // Rows are less than half a row from where their middles are.
        int first = std::clamp(static_cast<int>(std::floor(v * height_ - 0.5)), -1, height_ - 1);
        if (first < height_ - 1 && v >= place(first + 1))
            ++first;
        else if (first >= 0 && v < place(first))
            --first;
        return {first, first + 1, (v - place(first)) / (place(first + 1) - place(first))};
    }

private:
    double place(int row) const { return places_[static_cast<std::size_t>(row + 1)]; }

    int height_;
    std::vector<double> places_; // 0 to 1, with those of one row beyond each pole
};

} // namespace lambent::image
