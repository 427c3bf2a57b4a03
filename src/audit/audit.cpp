#include "audit/audit.h"

#include "audit/pixel_choice.h"
#include "base/hash.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lambent::audit {
namespace {

using Color = glm::dvec3;

// What the parts of an audit are random by.
enum class Random : std::uint32_t { places = 0x61756469, glance, choice, bootstrap, light };

std::uint32_t seed_of(const Settings& settings, Random part)
{
    return hashed(settings.seed, static_cast<std::uint32_t>(part));
}

// The seed of a part's paths: with a bit that no seed has which a user can give to the picture.
std::uint32_t path_seed(std::uint32_t seed)
{
    return seed | 1u << 31;
}

Color cut_off(const Color& light, double cut)
{
    return glm::clamp(light, 0.0, cut);
}

Color shown(const image::RadianceImage& picture, const Place& at, double cut)
{
    Color value;
    for (int c = 0; c < 3; ++c) {
        const double v = static_cast<double>(picture.pixel(at.x, at.y)[c]);
        value[c] = std::isfinite(v) ? v : 0.0;
    }
    return cut_off(value, cut);
}

double mean(const Color& color)
{
    return (color.x + color.y + color.z) / 3.0;
}

// What is known of a pixel before it is audited.
struct Glance {
    double score = 1.0; ///< its squared error at a glance, plus the mean of all
    double noise = 1.0; ///< in proportion to the variance of the cut light
};

double square(double x)
{
    return x * x;
}

// Of what the cut leaves of two deviations up and down.
double cut_noise(const reference::PixelEstimate& seen, double cut)
{
    double sum = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double far = 2.0 * std::sqrt(seen.variance[c]), light = seen.radiance[c];
        sum += square(std::clamp(light + far, 0.0, cut) - std::clamp(light - far, 0.0, cut));
    }
    return sum;
}

std::vector<Glance> glances(const std::vector<Candidate>& places, const image::RadianceImage& picture,
                            const Settings& settings, const PixelLight& light)
{
    std::vector<Glance> seen(places.size());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        const Place& at = places[i].at;
        const reference::PixelEstimate one =
            light({at.x, at.y, settings.glance_samples, path_seed(seed_of(settings, Random::glance))});
        const Color off = shown(picture, at, settings.cut) - cut_off(one.radiance, settings.cut);
        seen[i] = {mean(off * off), cut_noise(one, settings.cut)};
    });
    double sum = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i)
        sum += places[i].stands_for * seen[i].score;
    // Where every glance agrees with the picture, all are alike.
    const double usual = sum > 0.0 ? sum / static_cast<double>(seen.size()) : 1.0;
    for (Glance& one : seen)
        one.score += usual;
    return seen;
}

// One of each group of candidates, and its weight.
struct Audited {
    Place at;
    double weight = 1.0;
    double noise = 1.0; ///< as of Glance
    int samples = 0;    ///< of each of four estimates
};

std::vector<Audited> choose(const std::vector<Candidate>& candidates, const std::vector<Glance>& seen,
                            std::size_t group, std::uint32_t seed)
{
    std::vector<double> scores;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        scores.push_back(candidates[i].stands_for * seen[i].score);
    std::vector<Audited> audited;
    for (std::size_t first = 0; first < candidates.size(); first += group) {
        const double random = (hashed(seed, static_cast<std::uint32_t>(first)) + 0.5) * 0x1p-32;
        const Chosen one = chosen(std::span(scores).subspan(first, group), random);
        const Candidate& candidate = candidates[first + one.index];
        audited.push_back(
            {candidate.at, one.weight * candidate.stands_for, seen[first + one.index].noise, 0});
    }
    return audited;
}

// The noise of a squared error of weight w from n paths has the variance (w noise / n)^2. For a given sum of n the sum
// of these is least for n in proportion to (w noise)^(2/3). [Neyman 1934] As noise is known from a glance only,
// half of all is shared evenly, and no pixel gets more than 16 times the mean.
void share_samples(std::vector<Audited>& audited, int mean_samples)
{
    double sum = 0.0;
    const auto need = [](const Audited& one) { return std::cbrt(square(one.weight * one.noise)); };
    for (const Audited& one : audited)
        sum += need(one);
    for (Audited& one : audited) {
        const double part = sum > 0.0 ? need(one) * static_cast<double>(audited.size()) / sum : 1.0;
        const double samples = mean_samples * std::min(0.5 + 0.5 * part, 16.0);
        one.samples = std::max(static_cast<int>(samples / 2.0), 1);
    }
}

// The cut light of a pixel from two halves of its samples: the jackknife of the cut mean.
Color cut_mean(const Color& first, const Color& second, double cut)
{
    return 2.0 * cut_off(0.5 * (first + second), cut) - 0.5 * (cut_off(first, cut) + cut_off(second, cut));
}

Moments moments(const Color& picture, const Color& a, const Color& b)
{
    return {mean((picture - a) * (picture - b)), mean(0.5 * (a + b) - picture)};
}

// Four independent estimates make two independent halves in three ways. The mean of the three is without bias as each
// is, and has less noise, a third less in its variance.
Observation observe(const Audited& audited, const Color& picture, const Settings& settings,
                    const PixelLight& light)
{
    std::array<Color, 4> part;
    for (std::uint32_t i = 0; i < part.size(); ++i)
        part[i] = light({audited.at.x, audited.at.y, audited.samples,
                         path_seed(hashed(seed_of(settings, Random::light), i))})
                      .radiance;
    const double cut = settings.cut;
    Observation seen{audited.weight, {}, {}};
    for (const auto& [i, j, k, l] : {std::array{0u, 1u, 2u, 3u}, {0u, 2u, 1u, 3u}, {0u, 3u, 1u, 2u}}) {
        const Moments m = moments(picture, cut_mean(part[i], part[j], cut), cut_mean(part[k], part[l], cut));
        seen.moments.square += m.square / 3.0;
        seen.moments.difference += m.difference / 3.0;
    }
    for (std::size_t i = 0; i < 2; ++i)
        seen.half[i] = moments(picture, cut_off(part[2 * i], cut), cut_off(part[2 * i + 1], cut));
    return seen;
}

double mean_light(const std::vector<Place>& places, const image::RadianceImage& picture, double cut)
{
    double sum = 0.0;
    for (const Place& at : places)
        sum += mean(shown(picture, at, cut));
    return sum / static_cast<double>(places.size());
}

} // namespace

std::optional<Error> measure(const image::RadianceImage& picture, const Settings& settings,
                             const PixelLight& light)
{
    const std::vector<Place> covered = covered_pixels(picture);
    const std::size_t population = covered.size(),
                      pixels = std::min(population, static_cast<std::size_t>(settings.pixels));
    if (pixels < least_pixels)
        return std::nullopt;
    const Population all{population, mean_light(covered, picture, settings.cut),
                         seed_of(settings, Random::bootstrap)};
    const std::size_t group =
        std::clamp(population / pixels, std::size_t{1}, static_cast<std::size_t>(settings.candidates));
    const std::vector<Candidate> candidates = drawn(covered, interest(picture, covered, settings.cut),
                                                    group * pixels, seed_of(settings, Random::places));
    std::vector<Audited> audited = choose(candidates, glances(candidates, picture, settings, light), group,
                                          seed_of(settings, Random::choice));
    share_samples(audited, settings.samples);
    std::vector<Observation> observations(audited.size());
    tbb::parallel_for(std::size_t{0}, audited.size(), [&](std::size_t i) {
        observations[i] = observe(audited[i], shown(picture, audited[i].at, settings.cut), settings, light);
    });
    const Error error = error_of(observations, all);
    return std::isfinite(error.high) ? std::optional(error) : std::nullopt;
}

std::optional<Error> measure(const scene::Scene& scene, const image::RadianceImage* panorama,
                             const reference::Settings& truth, const image::RadianceImage& picture,
                             const Settings& settings)
{
    const reference::PixelTracer tracer(scene, panorama, truth);
    return measure(picture, settings,
                   [&](const reference::PixelTracer::Pixel& pixel) { return tracer.estimate(pixel); });
}

} // namespace lambent::audit
