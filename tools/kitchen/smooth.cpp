#include "kitchen/smooth.h"

#include "image/luminance.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lambent {
namespace {

constexpr int rounds = 5;                             // the last reaches 2 * 2^4 pixels to each side
constexpr float kernel[3] = {0.375f, 0.25f, 0.0625f}; // cubic B-spline, from its centre
constexpr float luminance_deviations = 3.0f;          // differences in luminance that count as noise
constexpr float normal_exponent = 48.0f;              // 10 degrees halve the weight
constexpr float plane_share = 0.01f;                  // of the distance: so far off a plane the weight is 1/e

// A pixel's radiance over its albedo, and the variance of that luminance.
struct Lit {
    glm::vec3 light{0.0f};
    float variance = 0.0f;
};
using LitImage = std::vector<Lit>;

struct Size {
    int width, height;

    std::size_t at(int x, int y) const
    {
        const int column = (x + width) % width, row = std::clamp(y, 0, height - 1);
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

float luminance(const glm::vec3& c)
{
    return static_cast<float>(image::luminance(&c.r));
}

// The weighted mean of the variance over 3x3 pixels: variances of eight replicates are imprecise.
float mean_variance(const LitImage& picture, const Size& size, int x, int y)
{
    float sum = 0.0f;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
            sum += kernel[std::abs(i)] * kernel[std::abs(j)] * picture[size.at(x + i, y + j)].variance;
    return sum / ((kernel[0] + 2.0f * kernel[1]) * (kernel[0] + 2.0f * kernel[1]));
}

// A weight from 0 to 1: 1 where two pixels show the same plane.
float likeness(const FirstHit& a, const FirstHit& b, float distance)
{
    if (std::fabs(a.coverage - b.coverage) > 0.05f)
        return 0.0f;
    const float bend = std::pow(std::max(glm::dot(a.normal, b.normal), 0.0f), normal_exponent);
    const float off =
        std::fabs(glm::dot(a.normal, b.position - a.position)) / (plane_share * distance + 1e-6f);
    return bend * std::exp(-off);
}

Lit filtered(const LitImage& picture, std::span<const FirstHit> hits, const Size& size, glm::ivec2 place,
             int step)
{
    const std::size_t middle = size.at(place.x, place.y);
    const FirstHit& here = hits[middle];
    const Lit& own = picture[middle];
    if (here.coverage < 0.5f)
        return own;
    const float tolerance =
        luminance_deviations * std::sqrt(mean_variance(picture, size, place.x, place.y)) + 1e-6f;
    const float distance = glm::length(here.position), light = luminance(own.light);
    Lit sum;
    float weights = 0.0f;
    for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i) {
            const std::size_t other = size.at(place.x + i * step, place.y + j * step);
            const float apart = std::fabs(luminance(picture[other].light) - light) / tolerance;
            const float weight = kernel[std::abs(i)] * kernel[std::abs(j)] * std::exp(-apart) *
                                 likeness(here, hits[other], distance);
            sum.light += weight * picture[other].light;
            sum.variance += weight * weight * picture[other].variance;
            weights += weight;
        }
    return weights > 0.0f ? Lit{sum.light / weights, sum.variance / (weights * weights)} : own;
}

// Removes fireflies: a pixel far brighter than all its neighbours is due to a single path. It is clamped to the
// brightest neighbour.
void take_out_sparks(LitImage& picture, const Size& size, std::span<const FirstHit> hits)
{
    const LitImage before = picture;
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            Lit& own = picture[size.at(x, y)];
            if (hits[size.at(x, y)].coverage < 0.5f)
                continue;
            float most = 0.0f;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    if (i != 0 || j != 0)
                        most = std::max(most, luminance(before[size.at(x + i, y + j)].light));
            const float light = luminance(own.light);
            if (light > 2.0f * most && light * light < 16.0f * own.variance) {
                own.light *= most / light;
                own.variance *= most * most / (light * light);
            }
        }
    });
}

// Sums of light over blocks of a picture, interpolated between the blocks' centres.
struct Blocks {
    int size, columns, rows;
    std::vector<glm::vec3> light;

    Blocks(const image::RadianceImage& image, int block)
        : size(block), columns((image.width + block - 1) / block), rows((image.height + block - 1) / block),
          light(static_cast<std::size_t>(columns * rows), glm::vec3(0.0f))
    {
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const float* c = image.pixel(x, y);
                light[static_cast<std::size_t>(y / size * columns + x / size)] += glm::vec3(c[0], c[1], c[2]);
            }
    }

    glm::vec3 at(int x, int y) const
    {
        const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size) - 0.5f;
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size) - 0.5f;
        const float left = std::floor(u), top = std::floor(v);
        const auto one = [&](float column, float row) {
            const int i = (static_cast<int>(column) + columns) % columns;
            const int j = std::clamp(static_cast<int>(row), 0, rows - 1);
            return light[static_cast<std::size_t>(j * columns + i)];
        };
        return glm::mix(glm::mix(one(left, top), one(left + 1.0f, top), u - left),
                        glm::mix(one(left, top + 1.0f), one(left + 1.0f, top + 1.0f), u - left), v - top);
    }
};

// Restores the energy of each block that the removal of fireflies and the filter changed.
void give_back(image::RadianceImage& smooth, const image::RadianceImage& traced)
{
    const int block = std::clamp(smooth.width / 32, 4, 64);
    Blocks ratio(smooth, block);
    const Blocks wanted(traced, block);
    for (std::size_t i = 0; i < ratio.light.size(); ++i)
        ratio.light[i] =
            glm::clamp(wanted.light[i] / glm::max(ratio.light[i], glm::vec3(1e-20f)), 0.5f, 2.0f);
    for (int y = 0; y < smooth.height; ++y)
        for (int x = 0; x < smooth.width; ++x) {
            const glm::vec3 factor = ratio.at(x, y);
            for (int c = 0; c < 3; ++c)
                smooth.pixel(x, y)[c] *= factor[c];
        }
}

} // namespace

image::RadianceImage smoothed(const image::RadianceImage& radiance, const image::RadianceImage& variance,
                              std::span<const FirstHit> hits)
{
    const Size size{radiance.width, radiance.height};
    LitImage picture(hits.size());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const float *c = radiance.pixel(x, y), *v = variance.pixel(x, y);
            const glm::vec3& albedo = hits[size.at(x, y)].albedo;
            Lit& lit = picture[size.at(x, y)];
            lit.light = glm::vec3(c[0], c[1], c[2]) / albedo;
            // The noise of the channels comes from the same paths, so standard deviations add up.
            const float deviation = luminance(glm::sqrt(glm::vec3(v[0], v[1], v[2])) / albedo);
            lit.variance = deviation * deviation;
        }
    take_out_sparks(picture, size, hits);
    for (int round = 0; round < rounds; ++round) {
        LitImage next(picture.size());
        tbb::parallel_for(0, size.height, [&](int y) {
            for (int x = 0; x < size.width; ++x)
                next[size.at(x, y)] = filtered(picture, hits, size, {x, y}, 1 << round);
        });
        picture.swap(next);
    }
    image::RadianceImage result{size.width, size.height, 3, {}};
    for (std::size_t i = 0; i < picture.size(); ++i)
        for (int c = 0; c < 3; ++c)
            result.values.push_back(picture[i].light[c] * hits[i].albedo[c]);
    give_back(result, radiance);
    return result;
}

} // namespace lambent
