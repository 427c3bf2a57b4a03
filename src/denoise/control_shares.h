// How far exact light is trusted as a control variate.
#pragma once

#include "denoise/light_filter.h"

#include <vector>

namespace lambent::denoise {

/// The share of the exact light whose noisy estimate is taken from the true light: the estimator exact + (found - unshadowed)
/// becomes found + s (exact - unshadowed). s is 1 where at least half of the unshadowed light arrives, and falls with the
/// square of that ratio: in a room lit through a small window, the exact light's own error of some percent, and the
/// difference of its texture from that of the samples, would be larger than all the light there is.
///
/// Ratios are pooled over squares of 16 pixels and their neighbours; shares between their centres are interpolated.
class ControlShares {
public:
    ControlShares(const Picture& picture, const Light& light);

    /// Shares, in [0, 1], of pixels from `first` on in row y.
    void fill(int y, int first, int columns, float* to) const;

private:
    float at(int column, int row) const;

    int columns_, rows_;        ///< squares
    std::vector<float> shares_; ///< of each
};

} // namespace lambent::denoise
