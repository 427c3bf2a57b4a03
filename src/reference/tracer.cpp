#include "reference/tracer.h"

#include "reference/samples/budget.h"
#include "reference/film.h"
#include "reference/traced_scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

namespace lambent::reference {
namespace {

using Clock = std::chrono::steady_clock;

// The first rounds double the samples of each pixel up to `settled`: only then is the noise known well enough to stop
// at a limit and to distribute samples by it. Each later round multiplies the number of samples by `growth`.
constexpr int settled = 2 * replicates;
constexpr double growth = 1.5;

class Tracer {
public:
    Tracer(const World& world, const Settings& settings)
        : world_(world), settings_(settings), lens_(lens_of(settings)),
          film_(settings.width, settings.height, settings.cut, world.has_unlit, settings.first_surfaces),
          order_(scattered_tiles(film_.columns(), film_.rows()))
    {
    }

    /// See Tracing::advance.
    bool advance(const GoOn& go_on, Least least);
    bool has(Least least) const { return fewest_ >= static_cast<int>(least); }

    Result result() const
    {
        Result result{film_.radiance(), film_.variance(), noise_, samples_, broken_, refused_, std::nullopt};
        if (settings_.first_surfaces)
            result.first_surfaces = film_.first_surfaces();
        return result;
    }

private:
    void round(const GoOn& go_on, Least least);
    void sample_tile(int tile, int count);
    void add_sample(const SeededPixel& pixel, int number);
    std::vector<int> next_counts() const;
    Progress progress() const;
    void ask(const GoOn& go_on, bool may_be_stopped, bool may_time_out);
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    bool reached_limit() const;

    const World& world_;
    const Settings& settings_;
    Lens lens_;
    Film film_;
    const std::vector<int> order_; ///< order of the tiles in every round
    std::vector<int> wanted_;      ///< samples per pixel of each tile, for the current round; empty: none
    Clock::time_point start_ = Clock::now();
    std::optional<Noise> noise_; ///< after the last round
    double samples_ = 0.0;       ///< per pixel, after the last round
    int fewest_ = 0;             ///< samples of any pixel, after the last round
    double noise_seconds_ = 0.0; ///< seconds from start_ to the end of the last round
    std::atomic<bool> stop_ = false, refused_ = false;
    std::atomic<std::uint64_t> broken_ = 0;
    std::mutex asking_;
};

void Tracer::add_sample(const SeededPixel& pixel, int number)
{
    FirstSurface first;
    const bool keeps_first = settings_.first_surfaces;
    Sight sight = sample_pixel(world_, lens_, pixel, number, keeps_first ? &first : nullptr);
    if (!mend(sight)) {
        ++broken_;
        first.emitted = glm::dvec3(0.0); // as the sample is black
    }
    film_.add(pixel.x, pixel.y, number, sight);
    if (keeps_first)
        film_.add(pixel.x, pixel.y, number, sight, first);
}

void Tracer::sample_tile(int tile, int count)
{
    const Film::Area a = film_.area(tile);
    for (int y = a.y; y < a.y + a.height; ++y)
        for (int x = a.x; x < a.x + a.width; ++x) {
            for (int i = film_.samples(tile); i < count; ++i)
                add_sample({x, y, settings_.seed}, i);
        }
    film_.finish(tile, count);
}

Progress Tracer::progress() const
{
    const double now = seconds();
    Progress p;
    p.noise = noise_;
    p.samples = samples_;
    // Progress towards the limit that will be reached first.
    p.done = now / settings_.seconds;
    if (samples_ > 0.0)
        p.done = std::max(p.done, samples_ / settings_.samples * (now / noise_seconds_));
    if (settings_.noise > 0.0 && noise_ && noise_->covered > 0.0)
        p.done = std::max(p.done, std::pow(settings_.noise / noise_->covered, 2) * (now / noise_seconds_));
    p.done = std::clamp(p.done, 1e-6, 1.0);
    p.seconds_left = now / p.done - now;
    return p;
}

void Tracer::ask(const GoOn& go_on, bool may_be_stopped, bool may_time_out)
{
    const std::unique_lock lock(asking_, std::try_to_lock);
    if (!lock)
        return;
    if (go_on && !refused_ && !go_on(progress()))
        refused_ = true;
    if ((refused_ && may_be_stopped) || (may_time_out && seconds() >= settings_.seconds))
        stop_ = true;
}

// Skips the tiles that an interrupted round completed. Each free thread takes the next tile of the order, so that at
// any interruption the completed tiles are spread over the picture.
void Tracer::round(const GoOn& go_on, Least least)
{
    const bool may_be_stopped = has(least), may_time_out = has(std::max(least, Least::one_sample));
    std::atomic<std::size_t> next = 0;
    tbb::parallel_for(0, film_.tile_count(), [&](int) {
        const int tile = order_[next++];
        const int count = wanted_[static_cast<std::size_t>(tile)];
        if (stop_ || count <= film_.samples(tile))
            return;
        sample_tile(tile, count);
        ask(go_on, may_be_stopped, may_time_out);
    });
    samples_ = film_.mean_samples();
    fewest_ = film_.fewest_samples();
    noise_ = film_.noise();
    noise_seconds_ = seconds();
}

// During an interrupted round only the limit of time counts: the noise of a picture with some tiles refined is that of
// no complete round.
bool Tracer::reached_limit() const
{
    if (seconds() >= settings_.seconds)
        return true;
    if (!wanted_.empty())
        return false;
    return samples_ >= settings_.samples ||
           (settings_.noise > 0.0 && samples_ >= settled && film_.noise_at_most() <= settings_.noise);
}

// The first round takes one sample of each pixel, so that a picture exists early. The next ones double the samples
// until the variance is known; later ones add ever more.
std::vector<int> Tracer::next_counts() const
{
    const std::size_t tiles = static_cast<std::size_t>(film_.tile_count());
    if (fewest_ < settled)
        return std::vector<int>(tiles, std::min(std::max(1, 2 * fewest_), settings_.samples));
    const double next =
        std::min(std::max(samples_ * growth, samples_ + replicates), static_cast<double>(settings_.samples));
    if (!settings_.adaptive) {
        const int whole = static_cast<int>(next) / replicates * replicates;
        const bool last = next >= settings_.samples;
        return std::vector<int>(tiles, last ? settings_.samples : whole);
    }
    std::vector<TileState> states;
    states.reserve(tiles);
    for (int tile = 0; tile < film_.tile_count(); ++tile)
        states.push_back({film_.samples(tile), film_.tile_variance(tile)});
    return share_samples(states, next * static_cast<double>(tiles), replicates);
}

bool Tracer::advance(const GoOn& go_on, Least least)
{
    stop_ = refused_ = false;
    const auto is_enough = [&] { return has(std::max(least, Least::one_sample)); };
    while (!reached_limit() || !is_enough()) {
        const double before = samples_;
        const bool begins = wanted_.empty();
        if (begins)
            wanted_ = next_counts();
        round(go_on, least);
        if (stop_)
            break;
        wanted_.clear();
        if (refused_ && has(least))
            break;
        if (begins && !(samples_ > before))
            return true; // no tile needs more samples
    }
    return reached_limit() && is_enough();
}

} // namespace

// All data that the tracer refers to, and the tracer.
struct Tracing::Parts {
    Parts(const scene::Scene& scene, const image::RadianceImage* panorama, const Settings& asked)
        : settings(asked), traced(scene, panorama, settings), tracer(traced.world(), settings)
    {
    }

    const Settings settings;
    const TracedScene traced;
    Tracer tracer;
};

Tracing::Tracing(const scene::Scene& scene, const image::RadianceImage* panorama, const Settings& settings)
    : parts_(std::make_unique<Parts>(scene, panorama, settings))
{
}

Tracing::~Tracing() = default;

bool Tracing::advance(const GoOn& go_on, Least least)
{
    return parts_->tracer.advance(go_on, least);
}

bool Tracing::has_picture() const
{
    return parts_->tracer.has(Least::one_sample);
}

Result Tracing::result() const
{
    return parts_->tracer.result();
}

Result trace(const scene::Scene& scene, const image::RadianceImage* panorama, const Settings& settings,
             const GoOn& go_on, Least least)
{
    Tracing tracing(scene, panorama, settings);
    tracing.advance(go_on, least);
    return tracing.result();
}

} // namespace lambent::reference
