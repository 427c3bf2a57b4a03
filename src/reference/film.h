// Where samples are gathered: each pixel's light, and how far off it may still be.
#pragma once

#include "image/image.h"
#include "reference/estimate.h"
#include "reference/path.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lambent::reference {

/// Relative RMSE that is expected of a picture: RMS of what its values are off, over their mean, both cut.
struct Noise {
    double all = 0.0;     ///< over all pixels
    double covered = 0.0; ///< over those in which a surface was seen; over all where there is none
};

/// Mean and variance of every pixel, by square tiles whose pixels all have the same number of samples. About 100 bytes a
/// pixel.
class Film {
public:
    static constexpr int tile_size = 16;

    /// So many pixels as noisy as each other are together off what they are expected to be by sqrt(2 / n) of the square,
    /// one standard deviation: an eighth of its root.
    static constexpr double least_pixels = 30.0;

    /// `cut`: values above it count as this, in what is said of noise. `unlit`: whether some sight may be of surfaces
    /// without lighting. Throws std::bad_alloc.
    Film(int width, int height, double cut, bool unlit = false);

    struct Area {
        int x, y, width, height;
    };
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int tile_count() const { return columns_ * rows_; }
    Area area(int tile) const;
    int samples(int tile) const { return tiles_[static_cast<std::size_t>(tile)].samples; }

    /// Sample `number` of a pixel. Tiles may be filled in parallel, one thread each.
    void add(int x, int y, int number, const Sight& sight);

    /// After all pixels of a tile have their samples below `count`.
    void finish(int tile, int count);

    /// Mean over a tile's pixels and channels of the expected square of what the cut value is off; needs two samples.
    double tile_variance(int tile) const;

    /// Nothing until every pixel has two samples: one tells no variance. Nothing either where less than about
    /// `least_pixels` hold all the noise, as a lamp of one pixel does: what so few are off is a matter of chance.
    std::optional<Noise> noise() const;

    /// What noise().covered is at most, surely enough to stop by it: where few pixels hold the noise, twice their
    /// estimate; infinite before every pixel has two samples.
    double noise_at_most() const;

    /// Samples per pixel, averaged, and of the tile that has fewest.
    double mean_samples() const;
    int fewest_samples() const;

    image::RadianceImage radiance() const; ///< RGBA, alpha is coverage
    image::RadianceImage
    variance() const; ///< RGB, of each value of radiance(), not cut; infinite after one sample

private:
    struct Pixel {
        std::array<Sums, 3> sums{};
        float coverage = 0.0f;
    };

    // Over some pixels and all channels.
    struct Totals {
        double error = 0.0, mean = 0.0; ///< of cut values; the error squared
        double squares = 0.0;           ///< of the pixels' squared errors
        int pixels = 0;

        void add(const Totals& more);
        double relative_error() const;
        bool is_known() const;
    };
    struct Tile {
        int samples = 0;
        Totals all, covered;
    };

    struct Both {
        Totals all, covered; ///< `covered` is all pixels where none is covered
    };
    Both totals() const;
    std::size_t index(int x, int y) const;
    template <class Visit>
    void for_each_pixel(Visit&& visit) const;

    int width_, height_, columns_, rows_;
    double cut_;
    std::vector<Pixel> pixels_;
    std::vector<Tile> tiles_;
    std::vector<float> unlit_; ///< RGBA sums, as RadianceImage::unlit; empty: none
};

} // namespace lambent::reference
