#include "denoise/control_shares.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lambent::denoise {
namespace {

constexpr int side = 16;

struct Sums {
    double unshadowed = 0.0, found = 0.0;
};

// Light of the pixels in a square, all channels and both halves.
Sums sums_of(const Picture& picture, const Light& light, int column, int row)
{
    Sums sums;
    const int right = std::min((column + 1) * side, picture.width),
              bottom = std::min((row + 1) * side, picture.height);
    for (int y = row * side; y < bottom; ++y)
        for (int x = column * side; x < right; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                  static_cast<std::size_t>(x);
            if (!(picture.guides.coverage[i] > 0.0f))
                continue;
            float unshadowed = 0.0f, found = 0.0f;
            for (const Half& half : light.halves)
                for (std::size_t c = 0; c < 3; ++c)
                    unshadowed += half.unshadowed[c][i], found += half.found[c][i];
            const auto weight = static_cast<double>(picture.guides.coverage[i] * picture.count[i]);
            sums.unshadowed += weight * static_cast<double>(unshadowed);
            sums.found += weight * static_cast<double>(found);
        }
    return sums;
}

float share_of(const Sums& sums)
{
    if (!(sums.unshadowed > 0.0))
        return 1.0f;
    const double ratio = sums.found / sums.unshadowed;
    return static_cast<float>(std::min(4.0 * ratio * ratio, 1.0));
}

} // namespace

ControlShares::ControlShares(const Picture& picture, const Light& light)
    : columns_((picture.width + side - 1) / side), rows_((picture.height + side - 1) / side)
{
    std::vector<Sums> squares(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    tbb::parallel_for(0, rows_, [&](int row) {
        for (int column = 0; column < columns_; ++column)
            squares[static_cast<std::size_t>(row * columns_ + column)] = sums_of(picture, light, column, row);
    });
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            Sums sums;
            for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows_ - 1); ++y)
                for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns_ - 1); ++x) {
                    const Sums& square = squares[static_cast<std::size_t>(y * columns_ + x)];
                    sums.unshadowed += square.unshadowed;
                    sums.found += square.found;
                }
            shares_.push_back(share_of(sums));
        }
}

float ControlShares::at(int column, int row) const
{
    return shares_[static_cast<std::size_t>(std::clamp(row, 0, rows_ - 1) * columns_ +
                                            std::clamp(column, 0, columns_ - 1))];
}

void ControlShares::fill(int y, int first, int columns, float* to) const
{
    const float down = (static_cast<float>(y) + 0.5f) / static_cast<float>(side) - 0.5f;
    const int row = static_cast<int>(std::floor(down));
    const auto of_column = [&](int column) {
        return std::lerp(at(column, row), at(column, row + 1), down - static_cast<float>(row));
    };
    // Between the centres of two columns of squares.
    for (int x = first; x < first + columns;) {
        const int column = (x + side / 2) / side - 1,
                  end = std::min((column + 1) * side + side / 2, first + columns);
        const float left = of_column(column),
                    step = (of_column(column + 1) - left) / static_cast<float>(side);
        for (; x < end; ++x)
            to[x - first] = left + step * (static_cast<float>(x - column * side - side / 2) + 0.5f);
    }
}

} // namespace lambent::denoise
