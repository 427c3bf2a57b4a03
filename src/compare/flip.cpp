#include "compare/flip.h"

#include "compare/flip_tile.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

namespace lambent::compare {
namespace {

// Counts finished tiles.
class Reporter {
public:
    Reporter(const Progress& progress, int total) : progress_(progress), total_(total) {}

    void one_done()
    {
        if (!progress_)
            return;
        const std::lock_guard lock(mutex_);
        progress_(static_cast<float>(++done_) / static_cast<float>(total_));
    }

private:
    const Progress& progress_;
    int total_, done_ = 0;
    std::mutex mutex_;
};

// Calls visit(tile) for tiles that cover the map, in parallel.
template <class Visit>
void for_each_tile(const ErrorMap& map, Visit&& visit)
{
    const int across = (map.width + tile_width - 1) / tile_width;
    const int down = (map.height + tile_height - 1) / tile_height;
    tbb::parallel_for(0, across * down, [&](int i) {
        const int left = i % across * tile_width, top = i / across * tile_height;
        visit(
            Tile{left, top, std::min(tile_width, map.width - left), std::min(tile_height, map.height - top)});
    });
}

ErrorMap empty_map(const Pair& pair)
{
    const image::RadianceImage &a = pair.picture, &b = pair.reference;
    if (a.width != b.width || a.height != b.height)
        throw std::invalid_argument("pictures of different size cannot be compared");
    ErrorMap map{a.width, a.height, {}};
    map.values.resize(static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height));
    return map;
}

int tile_count(const ErrorMap& map)
{
    return ((map.width + tile_width - 1) / tile_width) * ((map.height + tile_height - 1) / tile_height);
}

} // namespace

ErrorMap ldr_flip(const Pair& pair, const FlipSettings& settings)
{
    ErrorMap map = empty_map(pair);
    const FlipFilters filters = make_flip_filters(settings.pixels_per_degree);
    Reporter reporter(settings.progress, tile_count(map));
    for_each_tile(map, [&](const Tile& tile) {
        flip_tile(pair, filters, {true, 1.0f}, tile, map);
        reporter.one_done();
    });
    return map;
}

HdrFlip hdr_flip(const Pair& pair, const FlipSettings& settings)
{
    HdrFlip flip{empty_map(pair), exposures_for(pair.reference)};
    const FlipFilters filters = make_flip_filters(settings.pixels_per_degree);
    Reporter reporter(settings.progress, tile_count(flip.map));
    for_each_tile(flip.map, [&](const Tile& tile) {
        for (int i = 0; i < flip.exposures.count; ++i) {
            // The faintest and the brightest floats would need factors beyond a float's range.
            const double factor = std::clamp(std::exp2(flip.exposures.at(i)), 1e-38, 1e38);
            flip_tile(pair, filters, {false, static_cast<float>(factor)}, tile, flip.map);
        }
        reporter.one_done();
    });
    return flip;
}

} // namespace lambent::compare
