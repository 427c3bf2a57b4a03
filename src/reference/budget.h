// How many samples each tile gets next, and which tile when.
#pragma once

#include <span>
#include <vector>

namespace lambent::reference {

struct TileState {
    int samples;     ///< per pixel, so far; at least 2
    double variance; ///< mean over the tile of the variance of its pixels' values
};

/// Samples per pixel that each tile should have when `total` (the sum over all tiles) may be spent: those that make the
/// sum of all variances least, n_i proportional to the standard deviation of one sample [Neyman 1934], but never fewer
/// than a tile has, nor than a quarter of the mean: what was not seen yet tells no variance. Multiples of `step`.
std::vector<int> share_samples(std::span<const TileState> tiles, double total, int step);

/// The tiles of a picture, row by row from 0, each once, in an order whose first parts are spread evenly over it: after
/// each 2^k tiles of a picture of 2^a x 2^b, every rectangle of 1 / 2^k of it has one. [Sobol 1967]
std::vector<int> scattered_tiles(int columns, int rows);

} // namespace lambent::reference
