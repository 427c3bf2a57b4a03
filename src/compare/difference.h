// Numerical differences between two images, without a model of vision.
#pragma once

#include "compare/error_map.h"
#include "image/image.h"

#include <limits>
#include <span>

namespace lambent::compare {

/// The two images of a comparison. Only red, green and blue count. Both must have the same size and finite values (see
/// image_pair.h); the functions throw std::invalid_argument for images of different size.
struct Pair {
    const image::RadianceImage& picture;
    const image::RadianceImage& reference;
    std::span<const char> covered =
        {}; ///< of each pixel, whether it is compared by difference() and mean(); empty: all
};

struct Difference {
    double rmse = 0.0;          ///< sqrt(mean((a - b)^2)) over all values, a the picture and b the reference
    double relative_rmse = 0.0; ///< rmse / mean(b); infinite where only the mean of b is 0 or below
    double psnr = 0.0;          ///< 20 log10(peak / rmse), decibels; infinite for equal images
    double max = 0.0;           ///< largest |a - b|
};

/// `peak` is the largest possible value: 1 for codes.
Difference difference(const Pair& pair, double peak);

/// Number of pixels that are compared.
std::size_t pixel_count(const Pair& pair);

/// The mean of a map over the pixels that are compared.
double mean(const ErrorMap& map, const Pair& pair);

/// The largest value of an image, at least 0.
double largest_value(const image::RadianceImage& picture);

/// sqrt(mean((a - b)^2)) over the channels of each pixel.
ErrorMap absolute_error(const Pair& pair);

/// The same divided by the sum of the mean of the reference's channels there and a hundredth of the whole reference's
/// mean, which bounds the error at black pixels. 0 everywhere if the reference's mean is not above 0 and both agree.
ErrorMap relative_error(const Pair& pair);

struct RegionError {
    double mean = 0.0;    ///< over the regions: relative RMSE in each
    double largest = 0.0; ///< of them
    int regions = 0;      ///< number of those with pixels and light in the reference
};

/// Relative RMSE region by region, both images clamped to [0, limit] first: a bright region cannot hide a dark one, nor
/// a few bright pixels all others. `labels` has a region's number for each pixel, row by row; below 0: in no region.
/// Regions without light in the reference are left out. Throws std::invalid_argument for another number of labels.
RegionError region_error(const Pair& pair, std::span<const int> labels, float limit = 1.0f);

} // namespace lambent::compare
