// The ratio of a mean square to a squared mean, from a weighted sample, with its confidence interval.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::audit {

/// The measured error of a picture.
struct Error {
    double relative_rmse = 0.0; ///< the root of relative_mse, or 0 if that is negative
    double low = 0.0,
           high = 0.0;         ///< ends of the interval of relative_rmse, 0 <= low <= relative_rmse <= high
    double confidence = 0.95;  ///< probability that the interval holds the true value
    int pixels = 0;            ///< pixels that were traced for it
    double relative_mse = 0.0; ///< mean square error over squared mean; below 0 where noise hides the error
};

/// Two quantities of a pixel, as they are estimated.
struct Moments {
    double square = 0.0;     ///< its squared error, of either sign
    double difference = 0.0; ///< its light, less that of the picture
};

/// An audited pixel.
struct Observation {
    double weight =
        1.0; ///< factor that makes the mean over the observations one over the population, without bias
    Moments moments;
    Moments half
        [2]; ///< the same from two halves of the samples, independent of each other; without the cut's jackknife
};

/// The pixels of which the observations are a sample without replacement.
struct Population {
    std::size_t pixels = 0;
    double light = 0.0;     ///< of the picture, mean over these pixels
    std::uint32_t seed = 0; ///< of the bootstrap
};

/// The error and its interval, of independent observations, at least two. A mean light that is not above 0 gives a
/// `high` that is not finite.
///
/// The interval is the bootstrap-t of relative_mse, 2000 resamples: squared errors are heavy-tailed, and an interval that
/// is symmetric about the estimate would hold too few errors, nearly all misses on one side. [Efron and Tibshirani 1993,
/// "An introduction to the bootstrap", section 12.5] The variance is that of the linearised ratio, less its part that a
/// picture of few pixels does not have, because each is drawn once.
Error error_of(const std::vector<Observation>& observations, const Population& population);

} // namespace lambent::audit
