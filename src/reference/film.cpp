#include "reference/film.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent::reference {

Film::Film(int width, int height, double cut, bool unlit, bool firsts)
    : width_(width), height_(height), columns_((width + tile_size - 1) / tile_size),
      rows_((height + tile_size - 1) / tile_size), cut_(cut)
{
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    tiles_.resize(static_cast<std::size_t>(tile_count()));
    if (unlit)
        unlit_.resize(4 * pixels_.size(), 0.0f);
    if (firsts)
        firsts_.resize(pixels_.size());
}

Film::Area Film::area(int tile) const
{
    const int x = tile % columns_ * tile_size, y = tile / columns_ * tile_size;
    return {x, y, std::min(tile_size, width_ - x), std::min(tile_size, height_ - y)};
}

std::size_t Film::index(int x, int y) const
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
}

void Film::add(int x, int y, int number, const Sight& sight)
{
    Pixel& p = pixels_[index(x, y)];
    for (int c = 0; c < 3; ++c)
        p.sums[static_cast<std::size_t>(c)][static_cast<std::size_t>(number % replicates)] +=
            static_cast<float>(sight.radiance[c]);
    p.coverage += static_cast<float>(sight.coverage);
    if (!sight.unlit || unlit_.empty())
        return;
    float* const own = unlit_.data() + 4 * (&p - pixels_.data());
    for (int c = 0; c < 3; ++c)
        own[c] += static_cast<float>(sight.radiance[c]);
    own[3] += 1.0f;
}

void Film::add(int x, int y, int number, const Sight& sight, const FirstSurface& first)
{
    FirstSums& sums = firsts_[index(x, y)];
    sums.emitted += glm::vec3(first.emitted);
    for (int c = 0; c < 3; ++c) {
        const auto channel = static_cast<std::size_t>(c),
                   replicate = static_cast<std::size_t>(number % replicates);
        sums.reflected[channel][replicate] += static_cast<float>(sight.radiance[c] - first.emitted[c]);
        sums.albedo[channel][replicate] += static_cast<float>(first.albedo[c]);
    }
    sums.normal += glm::vec3(first.normal);
    sums.depth += static_cast<float>(first.depth);
}

void Film::Totals::add(const Totals& more)
{
    error += more.error;
    mean += more.mean;
    squares += more.squares;
    pixels += more.pixels;
}

// Each pixel has three values.
double Film::Totals::relative_error() const
{
    return mean > 0.0 ? std::sqrt(3.0 * pixels * error) / mean : 0.0;
}

// error^2 / squares is the participation ratio: the effective number of pixels that hold the noise.
bool Film::Totals::is_known() const
{
    return !(error > 0.0) || error * error >= least_pixels * squares;
}

void Film::finish(int tile, int count)
{
    Tile& t = tiles_[static_cast<std::size_t>(tile)];
    t = {count, {}, {}};
    const Area a = area(tile);
    for (int y = a.y; y < a.y + a.height; ++y)
        for (int x = a.x; x < a.x + a.width; ++x) {
            const Pixel& p = pixels_[index(x, y)];
            Totals sum;
            sum.pixels = 1;
            for (const Sums& sums : p.sums) {
                const Estimate e = estimate(sums, count, cut_);
                sum.error += e.cut_error;
                sum.mean += e.cut_mean;
            }
            sum.squares = sum.error * sum.error;
            t.all.add(sum);
            if (p.coverage > 0.0f)
                t.covered.add(sum);
        }
}

double Film::tile_variance(int tile) const
{
    const Totals& all = tiles_[static_cast<std::size_t>(tile)].all;
    return all.error / (3.0 * all.pixels);
}

Film::Both Film::totals() const
{
    Both both;
    for (const Tile& tile : tiles_) {
        both.all.add(tile.all);
        both.covered.add(tile.covered);
    }
    if (both.covered.pixels == 0)
        both.covered = both.all;
    return both;
}

std::optional<Noise> Film::noise() const
{
    if (fewest_samples() < 2)
        return std::nullopt;
    const Both both = totals();
    if (!both.all.is_known() || !both.covered.is_known())
        return std::nullopt;
    return Noise{both.all.relative_error(), both.covered.relative_error()};
}

double Film::noise_at_most() const
{
    if (fewest_samples() < 2)
        return std::numeric_limits<double>::infinity();
    const Totals covered = totals().covered;
    return covered.is_known() ? covered.relative_error() : 2.0 * covered.relative_error();
}

double Film::mean_samples() const
{
    double sum = 0.0;
    for (int tile = 0; tile < tile_count(); ++tile) {
        const Area a = area(tile);
        sum += static_cast<double>(samples(tile)) * a.width * a.height;
    }
    return sum / (static_cast<double>(width_) * height_);
}

int Film::fewest_samples() const
{
    return std::min_element(tiles_.begin(), tiles_.end(),
                            [](const Tile& a, const Tile& b) { return a.samples < b.samples; })
        ->samples;
}

template <class Visit>
void Film::for_each_pixel(Visit&& visit) const
{
    for (int tile = 0; tile < tile_count(); ++tile) {
        const Area a = area(tile);
        for (int y = a.y; y < a.y + a.height; ++y)
            for (int x = a.x; x < a.x + a.width; ++x)
                visit(x, y, std::max(samples(tile), 1));
    }
}

image::RadianceImage Film::radiance() const
{
    image::RadianceImage image = image::black_image(width_, height_, 4);
    image.unlit = unlit_;
    for_each_pixel([&](int x, int y, int samples) {
        const Pixel& p = pixels_[index(x, y)];
        for (std::size_t c = 0; c < 4 && !unlit_.empty(); ++c)
            image.unlit[4 * index(x, y) + c] /= static_cast<float>(samples);
        for (std::size_t c = 0; c < 3; ++c)
            image.pixel(x, y)[c] = static_cast<float>(estimate(p.sums[c], samples, cut_).mean);
        image.pixel(x, y)[3] = p.coverage / static_cast<float>(samples);
    });
    return image;
}

image::RadianceImage Film::variance() const
{
    image::RadianceImage image = image::black_image(width_, height_);
    for_each_pixel([&](int x, int y, int samples) {
        for (std::size_t c = 0; c < 3; ++c)
            image.pixel(x, y)[c] =
                static_cast<float>(estimate(pixels_[index(x, y)].sums[c], samples, cut_).variance);
    });
    return image;
}

namespace {

// A ratio's variance is that of its residuals. [linearisation: Cochran 1977, "Sampling techniques", section 2.11]
Estimate residual_of(const Sums& reflected, const Sums& albedo, int samples)
{
    double light = 0.0, share = 0.0;
    for (std::size_t r = 0; r < replicates; ++r) {
        light += static_cast<double>(reflected[r]);
        share += static_cast<double>(albedo[r]);
    }
    const double ratio = share > 0.0 ? light / share : 0.0;
    Sums residuals = reflected;
    for (std::size_t r = 0; r < replicates; ++r)
        residuals[r] -= static_cast<float>(ratio * static_cast<double>(albedo[r]));
    return estimate(residuals, samples, std::numeric_limits<double>::infinity());
}

} // namespace

FirstSurfaces Film::first_surfaces() const
{
    const image::RadianceImage black = image::black_image(width_, height_);
    FirstSurfaces firsts{
        black, black, black, black, std::vector<float>(pixels_.size()), std::vector<int>(pixels_.size())};
    for_each_pixel([&](int x, int y, int samples) {
        const std::size_t i = index(x, y);
        const FirstSums& sums = firsts_[i];
        const float share = 1.0f / static_cast<float>(samples);
        for (int c = 0; c < 3; ++c) {
            firsts.emitted.pixel(x, y)[c] = share * sums.emitted[c];
            const auto channel = static_cast<std::size_t>(c);
            firsts.albedo.pixel(x, y)[c] = static_cast<float>(
                estimate(sums.albedo[channel], samples, std::numeric_limits<double>::infinity()).mean);
            firsts.variance.pixel(x, y)[c] = static_cast<float>(
                residual_of(sums.reflected[channel], sums.albedo[channel], samples).variance);
            firsts.normal.pixel(x, y)[c] = share * sums.normal[c];
        }
        firsts.depth[i] = share * sums.depth;
        firsts.samples[i] = samples;
    });
    return firsts;
}

} // namespace lambent::reference
