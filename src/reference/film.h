// Where samples are gathered: each pixel's light, and how far off it may still be.
#pragma once

#include "image/image.h"
#include "reference/path.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::reference {

/// Mean and variance of every pixel, by square tiles whose pixels all have the same number of samples.
/// Sample i of a pixel belongs to replicate i % replicates: each is a sequence of its own, evenly spread and
/// independent of the others, so that their means tell the variance truly though samples of one sequence do not.
/// [randomised quasi-Monte Carlo: Owen 1997] About 100 bytes a pixel.
class Film {
public:
    static constexpr int replicates = 8;
    static constexpr int tile_size = 16;

    /// `unlit`: whether some sight may be of surfaces without lighting. Throws std::bad_alloc.
    Film(int width, int height, bool unlit = false);

    struct Area {
        int x, y, width, height;
    };
    int tile_count() const { return columns_ * rows_; }
    Area area(int tile) const;
    int samples(int tile) const { return samples_[static_cast<std::size_t>(tile)]; }

    /// Sample number `index` of a pixel. Tiles may be filled in parallel, one thread each.
    void add(int x, int y, int index, const Sight& sight);

    /// After all pixels of a tile have their samples below `count`.
    void finish(int tile, int count) { samples_[static_cast<std::size_t>(tile)] = count; }

    /// Mean over a tile's pixels and channels of the variance of the pixel's value; needs two samples.
    double tile_variance(int tile) const;

    /// RMS of the standard deviations of all values over their mean: what relative RMSE is expected.
    double relative_noise() const;

    /// Samples per pixel, averaged.
    double mean_samples() const;

    image::RadianceImage radiance() const; ///< RGBA, alpha is coverage
    image::RadianceImage
    variance() const; ///< RGB, of each value of radiance(); 0 where one sample tells nothing

private:
    struct Pixel {
        float sums[replicates][3] = {};
        float coverage = 0.0f;
    };
    struct Estimate {
        double mean[3], variance[3];
    };
    Estimate estimate(const Pixel& pixel, int samples) const;
    const Pixel& pixel(int x, int y) const;
    template <class Visit>
    void for_each_pixel(Visit&& visit) const;

    int width_, height_, columns_, rows_;
    std::vector<Pixel> pixels_;
    std::vector<float> unlit_; ///< RGBA sums, as RadianceImage::unlit; empty: none
    std::vector<int> samples_;
};

} // namespace lambent::reference
