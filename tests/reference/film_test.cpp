// Means and variances of pixels, against the formula written out.
#include "reference/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace lambent::reference {
namespace {

// Samples of a pixel: some skewed law with mean 1/3, 2/3 and 1 and variances 4/45 times 1, 4 and 9.
Sight sample(std::mt19937& random)
{
    std::uniform_real_distribution<double> uniform;
    const double u = uniform(random), v = u * u;
    return {{v, 2.0 * v, 3.0 * v}, u < 0.25 ? 0.0 : 1.0};
}

constexpr double not_cut = std::numeric_limits<double>::infinity();

// Variance of the mean by 8 replicates of as many samples each: their means' sample variance over 8.
double direct_variance(const std::vector<double>& values)
{
    const std::size_t used = std::min<std::size_t>(values.size(), replicates);
    std::vector<double> means;
    for (std::size_t r = 0; r < used; ++r) {
        double sum = 0.0, count = 0.0;
        for (std::size_t i = r; i < values.size(); i += replicates, count += 1.0)
            sum += values[i];
        means.push_back(sum / count);
    }
    double mean = 0.0, squares = 0.0;
    for (const double m : means)
        mean += m / static_cast<double>(used);
    for (const double m : means)
        squares += (m - mean) * (m - mean);
    return squares / static_cast<double>(used - 1) / static_cast<double>(used);
}

TEST(ReferenceFilm, MeanAndVarianceAreTheFormulas)
{
    for (const int count : {1, 2, 5, 8, 16, 24, 400}) {
        Film film(19, 17, not_cut); // four tiles, three of them cut off
        std::mt19937 random(static_cast<unsigned>(count));
        std::vector<std::vector<double>> values(19 * 17);
        std::vector<double> covered(19 * 17, 0.0);
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 19; ++x)
                for (int i = 0; i < count; ++i) {
                    const Sight sight = sample(random);
                    const auto at = static_cast<std::size_t>(19 * y + x);
                    values[at].push_back(sight.radiance.y);
                    covered[at] += sight.coverage / count;
                    film.add(x, y, i, sight);
                }
        ASSERT_EQ(film.tile_count(), 4);
        for (int tile = 0; tile < 4; ++tile)
            film.finish(tile, count);
        EXPECT_EQ(film.mean_samples(), count);
        const image::RadianceImage radiance = film.radiance(), variance = film.variance();
        for (std::size_t i = 0; i < values.size(); ++i) {
            double mean = 0.0;
            for (const double v : values[i])
                mean += v / count;
            EXPECT_NEAR(radiance.values[4 * i + 1], mean, 1e-5);
            EXPECT_NEAR(radiance.values[4 * i + 2], 1.5 * mean, 1e-5);
            EXPECT_NEAR(radiance.values[4 * i + 3], covered[i], 1e-5);
            if (count > 1)
                EXPECT_NEAR(variance.values[3 * i + 1], direct_variance(values[i]), 1e-6);
            else
                EXPECT_EQ(variance.values[3 * i + 1], std::numeric_limits<float>::infinity());
        }
    }
}

TEST(ReferenceFilm, TilesCoverThePictureOnce)
{
    const Film film(50, 33, not_cut);
    std::vector<int> covered(50 * 33, 0);
    for (int tile = 0; tile < film.tile_count(); ++tile) {
        const Film::Area a = film.area(tile);
        for (int y = a.y; y < a.y + a.height; ++y)
            for (int x = a.x; x < a.x + a.width; ++x)
                ++covered.at(static_cast<std::size_t>(50 * y + x));
    }
    EXPECT_EQ(covered, std::vector<int>(50 * 33, 1));
}

// 100 x 100 pixels: the mean of their variances is that of the law within 5 of its own deviations. The sample variance
// of n normal values is off by sqrt(2 / (n - 1)) of itself; of so skewed a law by up to twice that.
TEST(ReferenceFilm, VarianceIsUnbiased)
{
    constexpr int size = 100;
    for (const int count : {2, 8, 9, 12, 16, 23, 64}) {
        Film film(size, size, not_cut);
        std::mt19937 random(7);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (int i = 0; i < count; ++i)
                    film.add(x, y, i, sample(random));
        for (int tile = 0; tile < film.tile_count(); ++tile)
            film.finish(tile, count);
        const image::RadianceImage variance = film.variance();
        double sum = 0.0;
        for (std::size_t i = 0; i < variance.values.size(); i += 3)
            sum += static_cast<double>(variance.values[i]);
        const double used = std::min(count, replicates);
        EXPECT_NEAR(sum / (size * size) * count / (4.0 / 45.0), 1.0,
                    5.0 * 2.0 * std::sqrt(2.0 / (used - 1.0)) / size);
    }
}

// Three tiles, by hand. Replicates 1 and 3 are a mean of 2 with variance 1; the first tile is quiet, the last has no
// surface and is cut.
Film three_tiles(double cut)
{
    Film film(48, 16, cut);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 48; ++x)
            for (int i = 0; i < 2; ++i)
                film.add(x, y, i,
                         {glm::dvec3(x < 16   ? 2.0
                                     : x < 32 ? 1.0 + 2.0 * i
                                              : 9.0 + 2.0 * i),
                          x < 32 ? 1.0 : 0.0});
    for (int tile = 0; tile < 3; ++tile)
        film.finish(tile, 2);
    return film;
}

TEST(ReferenceFilm, NoiseIsTheRootMeanSquareOverTheMean)
{
    const Film film = three_tiles(not_cut);
    EXPECT_NEAR(film.tile_variance(0), 0.0, 1e-12);
    EXPECT_NEAR(film.tile_variance(1), 1.0, 1e-12);
    EXPECT_NEAR(film.noise().value().all, std::sqrt(2.0 / 3.0) / (14.0 / 3.0), 1e-12);
    EXPECT_NEAR(film.noise()->covered, std::sqrt(0.5) / 2.0, 1e-12);
}

// At 4 the last tile is 4 whatever its samples: no error, though both samples differ.
TEST(ReferenceFilm, NoiseIsThatOfCutLight)
{
    const Film film = three_tiles(4.0);
    EXPECT_NEAR(film.tile_variance(2), 0.0, 1e-12);
    EXPECT_NEAR(film.noise().value().all, std::sqrt(1.0 / 3.0) / (8.0 / 3.0), 1e-12);
    EXPECT_NEAR(film.variance().pixel(40, 3)[1], 1.0, 1e-6) << "not cut";
}

TEST(ReferenceFilm, WithoutSurfacesAllPixelsCount)
{
    Film film(16, 16, not_cut);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (int i = 0; i < 2; ++i)
                film.add(x, y, i, {glm::dvec3(1.0 + 2.0 * i), 0.0});
    film.finish(0, 2);
    EXPECT_NEAR(film.noise().value().covered, 0.5, 1e-12);
}

// Independent samples of 0 and 2 in `noisy` pixels, the others 1.
Film noisy_pixels(int noisy)
{
    Film film(16, 16, not_cut);
    for (int i = 0; i < 2; ++i)
        for (int pixel = 0; pixel < 256; ++pixel)
            film.add(pixel % 16, pixel / 16, i, {glm::dvec3(pixel < noisy ? 2.0 * i : 1.0), 1.0});
    film.finish(0, 2);
    return film;
}

TEST(ReferenceFilm, NothingIsClaimedOfAFewPixelsThatHoldAllNoise)
{
    EXPECT_EQ(noisy_pixels(0).noise().value().all, 0.0);
    EXPECT_FALSE(noisy_pixels(1).noise().has_value());
    EXPECT_FALSE(noisy_pixels(29).noise().has_value());
    EXPECT_NEAR(noisy_pixels(30).noise().value().all, std::sqrt(30.0 / 256.0), 1e-12);
    EXPECT_NEAR(noisy_pixels(29).noise_at_most(), 2.0 * std::sqrt(29.0 / 256.0), 1e-12);
    EXPECT_NEAR(noisy_pixels(31).noise_at_most(), std::sqrt(31.0 / 256.0), 1e-12);
}

// One tile of many with one sample: what it hides is not known.
TEST(ReferenceFilm, NothingIsClaimedBeforeEveryPixelHasTwoSamples)
{
    Film film(32, 16, not_cut);
    for (int tile = 0; tile < 2; ++tile)
        for (int i = 0; i < 1 + tile; ++i)
            for (int y = 0; y < 16; ++y)
                for (int x = 0; x < 16; ++x)
                    film.add(16 * tile + x, y, i, {glm::dvec3(1.0), 1.0});
    film.finish(0, 1);
    film.finish(1, 2);
    EXPECT_FALSE(film.noise().has_value());
    EXPECT_TRUE(std::isinf(film.noise_at_most()));
    EXPECT_EQ(film.fewest_samples(), 1);
    EXPECT_EQ(film.mean_samples(), 1.5);
}

} // namespace
} // namespace lambent::reference
