#include "draw/cpu/full_light.h"

#include "denoise/light_filter.h"
#include "draw/light/random_points.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambent::draw {
namespace {

// Camera rays that find places for the cache, at least.
constexpr double rays_of_cache = 60000.0;

// Those of one pixel, at most.
constexpr std::uint32_t most_of_pixel = 64;

// Samples of a pixel in a pass, one of each half.
constexpr std::uint32_t samples_of_pass = 2;

// Share of the lights' light that reaches a pixel, from its samples and, where they saw no light, from those of its
// neighbours. A difference would take another amount from the exact light than it has, where samples see the surfaces of a
// pixel in other parts: light at the dark foot of a wall.
glm::vec3 lit_share(const LightSums& sums, int x, int y)
{
    const view::PixelArea& area = sums.area;
    glm::vec3 share(1.0f);
    for (int c = 0; c < 3; ++c)
        for (int reach = 0; reach < 2; ++reach) {
            float all = 0.0f, lit = 0.0f;
            const int right = std::min(x + reach, area.x + area.width - 1),
                      bottom = std::min(y + reach, area.y + area.height - 1);
            for (int row = std::max(y - reach, area.y); row <= bottom; ++row)
                for (int column = std::max(x - reach, area.x); column <= right; ++column) {
                    const std::size_t pixel = sums.index(column, row);
                    all += at(sums.lights_unshadowed, pixel)[c];
                    lit += at(sums.lights_found, pixel)[c];
                }
            if (!(all > 0.0f))
                continue;
            share[c] = lit / all;
            break;
        }
    return share;
}

// Mean of the radiance that pixels with surfaces show.
float mean_of_covered(const Frame& frame)
{
    double sum = 0.0, covered = 0.0;
    const std::vector<float>& values = frame.radiance.values;
    for (std::size_t at = 0; at + 3 < values.size(); at += 4) {
        if (!(values[at + 3] > 0.0f))
            continue;
        covered += 1.0;
        for (std::size_t c = 0; c < 3; ++c)
            sum += static_cast<double>(values[at + c]) / 3.0;
    }
    const double mean = covered > 0.0 ? sum / covered : 0.0;
    return mean > 0.0 ? static_cast<float>(mean) : 1.0f;
}

// The pictures that the light of a class is part of.
struct Shown {
    std::vector<image::RadianceImage*> diffuse, specular, lights;
};

Shown shown_in(Frame& frame)
{
    Shown shown{{&frame.radiance}, {&frame.radiance}, {&frame.radiance}};
    for (Layer& layer : frame.layers) {
        if (layer.name == "light_ambient")
            shown.diffuse.push_back(&layer.image);
        if (layer.name == "light_specular")
            shown.specular.push_back(&layer.image);
        if (layer.name == "light_direct")
            shown.lights.push_back(&layer.image);
    }
    return shown;
}

void add_to_pixel(const std::vector<image::RadianceImage*>& images, int x, int y, const glm::vec3& change)
{
    for (image::RadianceImage* const image : images)
        for (int c = 0; c < 3; ++c)
            image->pixel(x, y)[c] += change[c];
}

} // namespace

FullLight::FullLight(const Settings& settings, const view::PixelArea& covered,
                     std::shared_ptr<const WorldCache> known)
    : settings_(settings), sums_(covered), tiles_(settings.width, settings.height),
      asks_cache_(settings.bounces > 1 && !known), passes_(settings.passes), known_(std::move(known))
{
}

// Where there are fewer covered pixels than rays, pixels have several.
RayGatherer::Places FullLight::wanted_places() const
{
    const denoise::Plane& coverage = sums_.picture.guides.coverage;
    const auto covered = std::count_if(coverage.begin(), coverage.end(), [](float c) { return c > 0.0f; });
    const double rays = rays_of_cache / std::max(static_cast<double>(covered), 1.0);
    return {std::clamp(static_cast<int>(std::sqrt(1.0 / rays)), 1, 16),
            std::clamp(static_cast<std::uint32_t>(std::min(rays, 1e6)), 1u, most_of_pixel),
            settings_.bounces > 2};
}

bool FullLight::find_known(const PictureContext& picture, const ForTiles& for_tiles, const Frame& frame)
{
    if (!asks_cache_ || known_)
        return true;
    places_.resize(static_cast<std::size_t>(tiles_.count()));
    const RayGatherer::Places wanted = wanted_places();
    tbb::enumerable_thread_specific<RayGatherer> gatherers([&] { return RayGatherer(picture, nullptr); });
    for_tiles(tiles_, [&](int tile) {
        gatherers.local().find_places(tiles_.area(tile), wanted, frame,
                                      places_[static_cast<std::size_t>(tile)]);
    });
    if (!tiles_.all_done())
        return false;
    tiles_.restart();
    CacheSizes sizes;
    sizes.unit = mean_of_covered(frame);
    known_ = fill_cache(std::exchange(places_, {}), sizes, settings_.bounces - 1);
    return true;
}

bool FullLight::gather(const PictureContext& picture, const ForTiles& for_tiles, const Frame& frame)
{
    for (; pass_ < passes_; ++pass_) {
        tbb::enumerable_thread_specific<RayGatherer> gatherers(
            [&] { return RayGatherer(picture, known_.get()); });
        for_tiles(tiles_, [&](int tile) {
            for (std::uint32_t i = 0; i < samples_of_pass; ++i)
                gatherers.local().gather(
                    tiles_.area(tile), static_cast<std::uint32_t>(pass_) * samples_of_pass + i, frame, sums_);
        });
        if (!tiles_.all_done())
            return false;
        tiles_.restart();
    }
    return true;
}

// Replaces the light of one class in a part of a row.
void FullLight::apply(const denoise::FilteredRow& row, const std::vector<image::RadianceImage*>& images) const
{
    const denoise::Picture& known = sums_.picture;
    const denoise::Rgb& exact = row.specular ? known.specular.exact : known.diffuse.exact;
    for (int i = 0; i < row.columns; ++i) {
        const int x = sums_.area.x + row.x + i, y = sums_.area.y + row.y;
        const std::size_t pixel = sums_.index(x, y), column = static_cast<std::size_t>(i);
        const float covered = known.guides.coverage[pixel];
        if (covered > 0.0f)
            add_to_pixel(images, x, y,
                         covered *
                             (glm::vec3(row.light[0][column], row.light[1][column], row.light[2][column]) -
                              at(exact, pixel)));
    }
}

void FullLight::apply(Frame& frame, const std::function<void()>& check) const
{
    const Shown shown = shown_in(frame);
    denoise::filter_light(sums_.picture, {settings_.white}, [&](const denoise::FilteredRow& row) {
        if (check)
            check();
        apply(row, row.specular ? shown.specular : shown.diffuse);
    });
    const view::PixelArea& area = sums_.area;
    tbb::parallel_for(area.y, area.y + area.height, [&](int y) {
        for (int x = area.x; x < area.x + area.width; ++x) {
            const std::size_t pixel = sums_.index(x, y);
            if (!(sums_.picture.guides.coverage[pixel] > 0.0f))
                continue;
            add_to_pixel(shown.lights, x, y, at(sums_.lights, pixel) * (lit_share(sums_, x, y) - 1.0f));
            for (int c = 0; c < 3; ++c) // what is less is rounding
                frame.radiance.pixel(x, y)[c] = std::max(frame.radiance.pixel(x, y)[c], 0.0f);
        }
    });
}

bool FullLight::advance(const PictureContext& picture, const ForTiles& for_tiles, const Frame& frame)
{
    if (!std::exchange(guided_, true))
        make_means(sums_);
    return find_known(picture, for_tiles, frame) && gather(picture, for_tiles, frame);
}

} // namespace lambent::draw
