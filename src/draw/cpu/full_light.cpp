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

// Camera rays that find places for the cache, about.
constexpr double rays_of_cache = 50000.0;

// Those of one pixel, at most.
constexpr std::uint32_t most_of_pixel = 64;

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

// Squared error of the lights' light at a pixel: each of its samples sees a light or not.
float error_of_lights(const LightSums& sums, std::size_t pixel)
{
    float error = 0.0f;
    for (int c = 0; c < 3 && sums.has_lights(); ++c) {
        const float all = at(sums.lights_unshadowed, pixel)[c], light = at(sums.lights, pixel)[c];
        const float lit = all > 0.0f ? at(sums.lights_found, pixel)[c] / all : 0.0f;
        error += light * light * std::max(lit * (1.0f - lit), 0.0f) / sums.picture.count[pixel];
    }
    return error;
}

void add_to_pixel(const std::vector<image::RadianceImage*>& images, int x, int y, const glm::vec3& change)
{
    for (image::RadianceImage* const image : images)
        for (int c = 0; c < 3; ++c)
            image->pixel(x, y)[c] += change[c];
}

} // namespace

FullLight::FullLight(const Settings& settings, const view::PixelArea& covered, bool has_lights,
                     std::shared_ptr<const WorldCache> known)
    : settings_(settings), sums_(covered, has_lights), tiles_(settings.width, settings.height),
      asks_cache_(settings.bounces > 1 && !known), passes_(settings.passes),
      plan_(covered.width, covered.height), known_(std::move(known))
{
}

// Where there are fewer covered pixels than rays, pixels have several.
RayGatherer::Places FullLight::wanted_places() const
{
    const denoise::Plane& coverage = sums_.picture.guides.coverage;
    const auto covered = std::count_if(coverage.begin(), coverage.end(), [](float c) { return c > 0.0f; });
    const double rays = rays_of_cache / std::max(static_cast<double>(covered), 1.0);
    return {static_cast<int>(std::clamp(std::lround(std::sqrt(1.0 / rays)), 1L, 16L)),
            std::clamp(static_cast<std::uint32_t>(std::min(rays, 1e6)), 1u, most_of_pixel),
            settings_.bounces > 2};
}

bool FullLight::find_known(const Job& job)
{
    if (!asks_cache_ || known_)
        return true;
    places_.resize(static_cast<std::size_t>(tiles_.count()));
    const RayGatherer::Places wanted = wanted_places();
    tbb::enumerable_thread_specific<RayGatherer> gatherers([&] { return RayGatherer(job.picture, nullptr); });
    job.for_tiles(tiles_, [&](int tile) {
        gatherers.local().find_places(tiles_.area(tile), wanted, job.frame,
                                      places_[static_cast<std::size_t>(tile)]);
    });
    if (!tiles_.all_done())
        return false;
    tiles_.restart();
    CacheSizes sizes;
    sizes.unit = mean_of_covered(job.frame);
    known_ = fill_cache(std::exchange(places_, {}), sizes, settings_.bounces - 1);
    return true;
}

// Gives the next pass's samples to where the filter's halves differ most, as far as a picture shows it.
void FullLight::plan_pass(const std::function<void()>& check)
{
    const denoise::Picture& known = sums_.picture;
    denoise::Plane error(known.guides.coverage.size(), 0.0f);
    denoise::filter_light(known, {settings_.white}, [&](const denoise::FilteredRow& row) {
        check();
        for (int i = 0; i < row.columns; ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const float light = row.light[c][i], half_gap = 0.5f * row.gap[c][i];
                const float shown =
                    std::min(light + std::fabs(half_gap), settings_.white) - std::min(light, settings_.white);
                error[static_cast<std::size_t>(row.y) * static_cast<std::size_t>(known.width) +
                      static_cast<std::size_t>(row.x + i)] += shown * shown;
            }
    });
    std::vector<SamplePlan::Square> squares(plan_.size());
    for (int y = 0; y < known.height; ++y)
        for (int x = 0; x < known.width; ++x) {
            const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(known.width) +
                               static_cast<std::size_t>(x);
            const float covered = known.guides.coverage[pixel];
            if (!(covered > 0.0f))
                continue;
            SamplePlan::Square& square = squares[plan_.square_of(x, y)];
            square.covered += 1.0;
            square.error +=
                static_cast<double>(covered * covered * error[pixel] + error_of_lights(sums_, pixel));
        }
    plan_.plan(squares);
}

bool FullLight::gather(const Job& job)
{
    for (; pass_ < passes_; ++pass_) {
        // Plans are made before passes 1, 2, 4, 8 ...: what follows changes them by little.
        if (planned_ != pass_ && (pass_ & (pass_ - 1)) == 0) {
            plan_pass(job.check);
            planned_ = pass_;
        }
        tbb::enumerable_thread_specific<RayGatherer> gatherers(
            [&] { return RayGatherer(job.picture, known_.get()); });
        job.for_tiles(tiles_, [&](int tile) {
            gatherers.local().gather(tiles_.area(tile), {pass_, plan_}, job.frame, sums_);
        });
        if (!tiles_.all_done())
            return false;
        tiles_.restart();
        plan_.end_pass();
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
            if (sums_.has_lights())
                add_to_pixel(shown.lights, x, y, at(sums_.lights, pixel) * (lit_share(sums_, x, y) - 1.0f));
            for (int c = 0; c < 3; ++c) // what is less is rounding
                frame.radiance.pixel(x, y)[c] = std::max(frame.radiance.pixel(x, y)[c], 0.0f);
        }
    });
}

bool FullLight::advance(const Job& job)
{
    if (!std::exchange(guided_, true))
        make_means(sums_);
    return find_known(job) && gather(job);
}

} // namespace lambent::draw
