// A value from its samples, and how far off it is: by what independent replicates of it show.
#pragma once

#include <array>

namespace lambent::reference {

/// Sample i of a value belongs to replicate i % replicates: each is a sequence of its own, evenly spread and
/// independent of the others, so that their means tell the variance truly though samples of one sequence do not.
/// [randomised quasi-Monte Carlo: Owen 1997]
constexpr int replicates = 8;

using Sums = std::array<float, replicates>; ///< of each replicate's samples

struct Estimate {
    double mean = 0.0; ///< of all samples
    double variance =
        0.0; ///< of the mean; without bias, also where replicates have different numbers of samples
    double cut_mean = 0.0; ///< min(mean, cut)
    /// Expected square of min(mean, cut) - min(truth, cut): the variance where the mean is below the cut; above, where
    /// the truth may be below it all the same, the jackknife's variance of the cut mean. [Tukey 1958; of unequal groups:
    /// Busing, Meijer and van der Leeden 1999, "Delete-m jackknife for unequal m"]
    double cut_error = 0.0;
};

/// Of sums over `samples`, 1 or more, dealt out as above. One sample tells no variance: variance and cut_error are
/// infinite then. `cut`: above 0, may be infinite.
Estimate estimate(const Sums& sums, int samples, double cut);

} // namespace lambent::reference
