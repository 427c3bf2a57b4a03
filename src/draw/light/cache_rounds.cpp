#include "draw/light/cache_rounds.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace lambent::draw {
namespace {

using Samples = std::vector<std::vector<PlaceSample>>;

// Growth of all light in a round below which no other follows.
constexpr double little = 0.001;

// Cells that became full have lost points that depend on the threads; wider ones take their place.
std::shared_ptr<const CacheCells> settled_cells(const Samples& samples, float side)
{
    for (;; side *= 2.0f) {
        auto cells = std::make_shared<CacheCells>(side);
        tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t part) {
            for (const PlaceSample& sample : samples[part])
                cells->count(sample.place);
        });
        if (cells->is_full())
            continue;
        cells->settle();
        return cells;
    }
}

// The cells of a sample's places, which are looked up once for all rounds.
struct Ends {
    CacheCells::Membership place;
    std::uint32_t further;
};
using EndsOfParts = std::vector<std::vector<Ends>>;

EndsOfParts ends_of(const Samples& samples, const CacheCells& cells)
{
    EndsOfParts ends(samples.size());
    tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t part) {
        for (const PlaceSample& sample : samples[part])
            ends[part].push_back({cells.cells_of(sample.place),
                                  sample.has_further ? cells.speaker_for(sample.further) : CacheCells::none});
    });
    return ends;
}

// The light of a place: what its sample has, and what the further place sends by the last round.
CachedLight light_of(const PlaceSample& sample, std::uint32_t further, const WorldCache* known)
{
    CachedLight light = sample.light;
    if (!known || !sample.has_further)
        return light;
    const std::array<glm::vec3, light_classes> sent = known->true_light(further, sample.further_light);
    for (std::size_t k = 0; k < light_classes; ++k)
        light.found[k] += sample.share[k] * (sent[diffuse_light] + sent[glossy_light]);
    return light;
}

double brightness_of(const CachedLight& light)
{
    const glm::vec3 sum = light.found[diffuse_light] + light.found[glossy_light];
    const double brightness = static_cast<double>(sum.r + sum.g + sum.b);
    return std::isfinite(brightness) ? brightness : 0.0;
}

} // namespace

std::shared_ptr<const WorldCache> fill_cache(const Samples& samples, CacheSizes sizes, int rounds)
{
    const std::shared_ptr<const CacheCells> cells = settled_cells(samples, sizes.side);
    const EndsOfParts ends = ends_of(samples, *cells);
    std::shared_ptr<const WorldCache> known;
    double before = 0.0;
    for (int round = 0; round < rounds; ++round) {
        auto next = std::make_shared<WorldCache>(cells, sizes.unit);
        std::vector<double> brightness(samples.size(), 0.0);
        tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t part) {
            for (std::size_t i = 0; i < samples[part].size(); ++i) {
                const CachedLight light = light_of(samples[part][i], ends[part][i].further, known.get());
                next->add(ends[part][i].place, light);
                brightness[part] += brightness_of(light);
            }
        });
        known = std::move(next);
        double all = 0.0;
        for (const double of_part : brightness)
            all += of_part;
        if (all - before <= little * all)
            break;
        before = all;
    }
    return known;
}

} // namespace lambent::draw
