#include "audit/pixel_choice.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

namespace lambent::audit {
namespace {

double contrast(const image::RadianceImage& picture, const Place& at, double cut)
{
    const auto value = [&](int x, int y, int c) {
        const double v = static_cast<double>(picture.pixel(x, y)[c]);
        return std::isfinite(v) ? std::clamp(v, 0.0, cut) : 0.0;
    };
    double sum = 0.0;
    int count = 0;
    for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, picture.height - 1); ++y)
        for (int x = std::max(at.x - 1, 0); x <= std::min(at.x + 1, picture.width - 1); ++x)
            for (int c = 0; c < 3; ++c, ++count) {
                const double difference = value(x, y, c) - value(at.x, at.y, c);
                sum += difference * difference;
            }
    return std::sqrt(sum / count);
}

// In proportion to the sizes, none above 1, adding up to `count`.
std::vector<double> probabilities(const std::vector<double>& sizes, std::size_t count)
{
    std::vector<double> result(sizes.size());
    double factor = static_cast<double>(count) / std::accumulate(sizes.begin(), sizes.end(), 0.0);
    for (bool rises = true; rises;) {
        double certain = 0.0, others = 0.0;
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            result[i] = std::min(factor * sizes[i], 1.0);
            (result[i] < 1.0 ? others : certain) += result[i] < 1.0 ? sizes[i] : 1.0;
        }
        const double next = others > 0.0 ? (static_cast<double>(count) - certain) / others : factor;
        rises = next > factor * (1.0 + 1e-9);
        factor = next;
    }
    return result;
}

} // namespace

std::vector<Place> covered_pixels(const image::RadianceImage& picture)
{
    std::vector<Place> places;
    if (picture.channels != 4)
        return places;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (picture.pixel(x, y)[3] > 0.0f)
                places.push_back({x, y});
    return places;
}

std::vector<double> interest(const image::RadianceImage& picture, const std::vector<Place>& places,
                             double cut)
{
    std::vector<double> result(places.size());
    tbb::parallel_for(std::size_t{0}, places.size(),
                      [&](std::size_t i) { result[i] = contrast(picture, places[i], cut); });
    const double sum = std::accumulate(result.begin(), result.end(), 0.0);
    for (double& one : result)
        one = sum > 0.0 ? 0.5 + 0.5 * one * static_cast<double>(places.size()) / sum : 1.0;
    return result;
}

// The generator is the standard's, so that the choice is the same everywhere.
std::vector<Candidate> drawn(const std::vector<Place>& places, const std::vector<double>& sizes,
                             std::size_t count, std::uint32_t seed)
{
    std::mt19937 random(seed);
    const std::vector<double> probability = probabilities(sizes, count);
    const double usual = static_cast<double>(count) / static_cast<double>(places.size());
    std::vector<Candidate> candidates;
    double next = (static_cast<double>(random()) + 0.5) * 0x1p-32, before = 0.0;
    for (std::size_t i = 0; i < places.size() && candidates.size() < count; ++i) {
        before += probability[i];
        // What is left is taken whatever rounding made of the sum.
        const bool last = places.size() - i <= count - candidates.size();
        if (before <= next && !last)
            continue;
        candidates.push_back({places[i], usual / probability[i]});
        next += 1.0;
    }
    for (std::size_t i = 0; i + 1 < candidates.size(); ++i) {
        const std::uint64_t left = candidates.size() - i;
        std::swap(candidates[i], candidates[i + static_cast<std::size_t>(random() * left >> 32)]);
    }
    return candidates;
}

Chosen chosen(std::span<const double> scores, double random)
{
    const double sum = std::accumulate(scores.begin(), scores.end(), 0.0);
    std::size_t index = 0;
    for (double before = scores[0]; index + 1 < scores.size() && before <= random * sum;
         before += scores[index])
        ++index;
    return {index, sum / static_cast<double>(scores.size()) / scores[index]};
}

} // namespace lambent::audit
