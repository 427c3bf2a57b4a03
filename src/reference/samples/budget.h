// The number of samples of each tile, and the order in which tiles are sampled.
#pragma once

#include <span>
#include <vector>

namespace lambent::reference {

struct TileState {
    int samples;     ///< taken so far, per pixel; at least 2
    double variance; ///< variance of a pixel's value, averaged over the tile
};

/// Distributes `total` (the sum over all tiles of samples per pixel) so that the sum of all variances is smallest:
/// n_i is proportional to the standard deviation of one sample [Neyman 1934]. No tile gets fewer samples than it has,
/// nor fewer than a quarter of the mean, because light that no sample met yet adds no variance. Numbers increase in
/// multiples of `step`.
std::vector<int> share_samples(std::span<const TileState> tiles, double total, int step);

/// All tiles of a picture, numbered row by row from 0, in an order whose first tiles are always spread evenly over
/// it: of 2^a x 2^b tiles, the first 2^k have one in every dyadic rectangle of 1 / 2^k of the picture. [Sobol 1967]
std::vector<int> scattered_tiles(int columns, int rows);

} // namespace lambent::reference
