#include "reference/film.h"

#include <algorithm>
#include <cmath>

namespace lambent::reference {

Film::Film(int width, int height, bool unlit)
    : width_(width), height_(height), columns_((width + tile_size - 1) / tile_size),
      rows_((height + tile_size - 1) / tile_size)
{
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    samples_.resize(static_cast<std::size_t>(tile_count()), 0);
    if (unlit)
        unlit_.resize(4 * pixels_.size(), 0.0f);
}

Film::Area Film::area(int tile) const
{
    const int x = tile % columns_ * tile_size, y = tile / columns_ * tile_size;
    return {x, y, std::min(tile_size, width_ - x), std::min(tile_size, height_ - y)};
}

const Film::Pixel& Film::pixel(int x, int y) const
{
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
}

void Film::add(int x, int y, int index, const Sight& sight)
{
    Pixel& p =
        pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    float* const sums = p.sums[index % replicates];
    for (int c = 0; c < 3; ++c)
        sums[c] += static_cast<float>(sight.radiance[c]);
    p.coverage += static_cast<float>(sight.coverage);
    if (!sight.unlit || unlit_.empty())
        return;
    float* const own = unlit_.data() + 4 * (&p - pixels_.data());
    for (int c = 0; c < 3; ++c)
        own[c] += static_cast<float>(sight.radiance[c]);
    own[3] += 1.0f;
}

Film::Estimate Film::estimate(const Pixel& pixel, int samples) const
{
    Estimate e{};
    const int used = std::min(samples, replicates);
    for (int c = 0; c < 3; ++c) {
        double sum = 0.0, squares = 0.0, total = 0.0;
        for (int r = 0; r < used; ++r) {
            const int count = (samples - r + replicates - 1) / replicates;
            const double all = static_cast<double>(pixel.sums[r][c]), mean = all / count;
            total += all;
            sum += mean;
            squares += mean * mean;
        }
        e.mean[c] = samples > 0 ? total / samples : 0.0;
        if (used > 1)
            e.variance[c] = std::max(squares - sum * sum / used, 0.0) / (used * (used - 1.0));
    }
    return e;
}

double Film::tile_variance(int tile) const
{
    const Area a = area(tile);
    double sum = 0.0;
    for (int y = a.y; y < a.y + a.height; ++y)
        for (int x = a.x; x < a.x + a.width; ++x) {
            const Estimate e = estimate(pixel(x, y), samples(tile));
            sum += e.variance[0] + e.variance[1] + e.variance[2];
        }
    return sum / (3.0 * a.width * a.height);
}

template <class Visit>
void Film::for_each_pixel(Visit&& visit) const
{
    for (int tile = 0; tile < tile_count(); ++tile) {
        const Area a = area(tile);
        for (int y = a.y; y < a.y + a.height; ++y)
            for (int x = a.x; x < a.x + a.width; ++x)
                visit(x, y, samples(tile));
    }
}

double Film::relative_noise() const
{
    double variance = 0.0, mean = 0.0;
    for_each_pixel([&](int x, int y, int samples) {
        const Estimate e = estimate(pixel(x, y), samples);
        for (int c = 0; c < 3; ++c) {
            variance += e.variance[c];
            mean += e.mean[c];
        }
    });
    const double values = 3.0 * width_ * height_;
    return mean > 0.0 ? std::sqrt(variance / values) / (mean / values) : 0.0;
}

double Film::mean_samples() const
{
    double sum = 0.0;
    for_each_pixel([&](int, int, int samples) { sum += samples; });
    return sum / (static_cast<double>(width_) * height_);
}

image::RadianceImage Film::radiance() const
{
    image::RadianceImage image{width_, height_, 4, {}};
    image.values.resize(pixels_.size() * 4);
    image.unlit = unlit_;
    for_each_pixel([&](int x, int y, int samples) {
        for (std::size_t c = 0; c < 4 && !unlit_.empty(); ++c)
            image.unlit[4 * static_cast<std::size_t>(&pixel(x, y) - pixels_.data()) + c] /=
                static_cast<float>(std::max(samples, 1));
        const Estimate e = estimate(pixel(x, y), samples);
        for (int c = 0; c < 3; ++c)
            image.pixel(x, y)[c] = static_cast<float>(e.mean[c]);
        image.pixel(x, y)[3] = pixel(x, y).coverage / static_cast<float>(std::max(samples, 1));
    });
    return image;
}

image::RadianceImage Film::variance() const
{
    image::RadianceImage image{width_, height_, 3, {}};
    image.values.resize(pixels_.size() * 3);
    for_each_pixel([&](int x, int y, int samples) {
        const Estimate e = estimate(pixel(x, y), samples);
        for (int c = 0; c < 3; ++c)
            image.pixel(x, y)[c] = static_cast<float>(e.variance[c]);
    });
    return image;
}

} // namespace lambent::reference
