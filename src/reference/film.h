// Accumulates samples: the light of each pixel, and its estimated error.
#pragma once

#include "image/image.h"
#include "reference/first_surface.h"
#include "reference/path.h"
#include "reference/samples/estimate.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lambent::reference {

/// Expected relative RMSE of a picture: root mean square error of its values over their mean, both of cut values.
struct Noise {
    double all = 0.0;     ///< over all pixels
    double covered = 0.0; ///< over pixels in which a surface was seen; over all if there is none
};

/// Mean and variance of every pixel. All pixels of a square tile have the same number of samples. Takes about 100
/// bytes per pixel, with first surfaces 220 more.
class Film {
public:
    static constexpr int tile_size = 16;

    /// The squared error of n equally noisy pixels has a relative standard deviation of sqrt(2 / n). For 30 pixels
    /// that is an eighth of the root mean square error.
    static constexpr double least_pixels = 30.0;

    /// `cut`: larger values count as this in estimates of noise. `unlit`: whether samples may show surfaces without
    /// lighting. `firsts`: whether first surfaces are kept. Throws std::bad_alloc.
    Film(int width, int height, double cut, bool unlit = false, bool firsts = false);

    struct Area {
        int x, y, width, height;
    };
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int tile_count() const { return columns_ * rows_; }
    Area area(int tile) const;
    int samples(int tile) const { return tiles_[static_cast<std::size_t>(tile)].samples; }

    /// Adds sample `number` of a pixel. Tiles may be filled in parallel, each by one thread.
    void add(int x, int y, int number, const Sight& sight);

    /// Adds what the ray of a sample met first, after the sample itself. Only for a film that keeps it.
    void add(int x, int y, int number, const Sight& sight, const FirstSurface& first);

    /// Sums up a tile. All its pixels must have their samples with numbers below `count`.
    void finish(int tile, int count);

    /// Expected squared error of the cut values, averaged over a tile's pixels and channels. Needs two samples.
    double tile_variance(int tile) const;

    /// Returns nothing until every pixel has two samples, because one gives no variance, nor while fewer than about
    /// `least_pixels` hold all the noise, as with a lamp of one pixel: the error of so few is a matter of chance.
    std::optional<Noise> noise() const;

    /// Upper limit of noise().covered, safe enough to stop by: twice the estimate if few pixels hold the noise;
    /// infinite until every pixel has two samples.
    double noise_at_most() const;

    /// Samples per pixel: on average, and in the tile with the fewest.
    double mean_samples() const;
    int fewest_samples() const;

    /// RGBA; alpha is coverage.
    image::RadianceImage radiance() const;
    /// RGB variance of each value of radiance(), not cut; infinite after one sample.
    image::RadianceImage variance() const;
    /// Means of first surfaces. Only of a film that keeps them.
    FirstSurfaces first_surfaces() const;

private:
    struct Pixel {
        std::array<Sums, 3> sums{};
        float coverage = 0.0f;
    };

    struct FirstSums {
        std::array<Sums, 3> reflected{}, albedo{};
        glm::vec3 emitted{0.0f}, normal{0.0f};
        float depth = 0.0f;
    };

    // Sums over some pixels and all channels.
    struct Totals {
        double error = 0.0, mean = 0.0; ///< squared errors, and means, of cut values
        double squares = 0.0;           ///< squares of each pixel's `error`
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
        Totals all, covered; ///< `covered` equals `all` if no pixel is covered
    };
    Both totals() const;
    std::size_t index(int x, int y) const;
    template <class Visit>
    void for_each_pixel(Visit&& visit) const;

    int width_, height_, columns_, rows_;
    double cut_;
    std::vector<Pixel> pixels_;
    std::vector<Tile> tiles_;
    std::vector<float> unlit_;      ///< RGBA sums for RadianceImage::unlit; empty if no surface is unlit
    std::vector<FirstSums> firsts_; ///< empty: not kept
};

} // namespace lambent::reference
