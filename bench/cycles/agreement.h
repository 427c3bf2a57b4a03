// Do both programs show the same light?
#pragma once

#include "bench/cycles/statistics.h"
#include "bench/cycles/white_grid.h"

namespace lambent::bench {

/// Many pictures of each program that differ only by their seeds.
struct SamePictures {
    std::vector<Taken> lambent, cycles;
};

/// Prints, for each roughness: how far lambent's mean over the spheres is from Cycles', the standard error of that,
/// and the shares of spheres and of pixels whose |z| is above 3. Where nothing but noise differs, z is about
/// Student's with 2 (n - 1) degrees for n seeds: 1 % of pixels at 8. The share between two halves of one program's
/// pictures (n - 2 degrees: 2.4 % at 8) stands beside it, as pixels' noise is not normal.
void print_agreement(const SamePictures& same, const std::vector<Column>& columns);

} // namespace lambent::bench
