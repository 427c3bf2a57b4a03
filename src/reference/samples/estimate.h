// Mean and error of a value, estimated from independent replicates of its samples.
#pragma once

#include <array>

namespace lambent::reference {

/// Sample i of a value belongs to replicate i % replicates. Each replicate is an evenly distributed sequence,
/// independent of the others, so that their means give an unbiased variance. The samples of one sequence would not.
/// [randomised quasi-Monte Carlo: Owen 1997]
constexpr int replicates = 8;

using Sums = std::array<float, replicates>; ///< sum of the samples of each replicate

struct Estimate {
    double mean = 0.0; ///< of all samples
    /// Variance of the mean, unbiased even if replicates have different numbers of samples.
    double variance = 0.0;
    double cut_mean = 0.0; ///< min(mean, cut)
    /// Expected square of min(mean, cut) - min(truth, cut): the variance if the mean is below the cut. A mean above the
    /// cut may have a true value below it; the error is then the jackknife variance of the cut mean. [Tukey 1958; for
    /// unequal groups: Busing, Meijer and van der Leeden 1999, "Delete-m jackknife for unequal m"]
    double cut_error = 0.0;
};

/// Estimate from the sums of `samples` samples, 1 or more, in replicates as above. One sample gives no variance:
/// variance and cut_error are then infinite. `cut`: above 0, may be infinite.
Estimate estimate(const Sums& sums, int samples, double cut);

} // namespace lambent::reference
