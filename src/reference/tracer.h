// The reference renderer: a picture by path tracing, and its estimated noise.
#pragma once

#include "image/image.h"
#include "reference/film.h"
#include "reference/path.h"
#include "scene/scene.h"
#include "view/picture.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace lambent::reference {

/// What to trace and when to stop: at the first limit reached, but never before each pixel has one sample. Rounds
/// bring the whole picture to 1, 2, 4, 8, 16 and ever more samples per pixel, each in an order of tiles that is
/// spread over the picture.
struct Settings : view::Picture {
    /// 0: direct light without shadows, which image based lighting approximates; 1: with shadows.
    int bounces = 8;
    std::optional<glm::vec3> panorama_from; ///< all directions from this point, not the camera's picture
    Strategy strategy = Strategy::both;
    int samples = 1 << 20; ///< limit per pixel, on average
    double noise = 0.0;    ///< limit of the estimated relative RMSE over covered pixels (Noise); 0: none
    /// Radiance above this counts as this in all estimates of noise, because pixels brighter than a display's white
    /// would outweigh all others. Above 0.
    double cut = std::numeric_limits<double>::infinity();
    double seconds = std::numeric_limits<double>::infinity(); ///< limit of time
    /// Whether noisy tiles get more samples than others. The numbers of samples then depend on the samples, which
    /// biases values downwards by a small part of the noise. [Kirk and Arvo 1991]
    bool adaptive = false;
    std::uint32_t seed = 0;
    bool first_surfaces = false; ///< whether the result has them; the light is the same
};

struct Progress {
    double done = 0.0;          ///< progress towards the first limit, 0 to 1
    std::optional<Noise> noise; ///< after the last round, if it is known: see Film::noise
    double samples = 0.0;       ///< per pixel, after the last round
    double seconds_left = 0.0;
};

struct Result {
    image::RadianceImage radiance; ///< RGBA before exposure and tone curve; alpha is coverage by surfaces
    image::RadianceImage variance; ///< RGB, of each value of `radiance`, not cut; infinite after one sample
    std::optional<Noise> noise;    ///< if it is known: see Film::noise
    double samples = 0.0;          ///< per pixel, on average
    std::uint64_t broken = 0;      ///< samples that were not finite and count as black
    bool stopped = false;          ///< whether `go_on` returned false
    std::optional<FirstSurfaces> first_surfaces; ///< if they were asked for
};

/// Called repeatedly, by one thread at a time; returns whether to continue.
using GoOn = std::function<bool(const Progress&)>;

/// What must be complete before tracing may be stopped: nothing, or one or two samples of each pixel. Two give the
/// noise.
enum class Least { nothing, one_sample, two_samples };

/// Traces a scene lit by a panorama (RGB, finite, not negative, 2x1 or more; null: black). After `go_on` returned
/// false, the result so far is returned, though not before `least` is complete. Camera rays, and the box filter over
/// pixels, are those of draw/. Throws Error(no_device) where Embree does not run.
Result trace(const scene::Scene& scene, const image::RadianceImage* panorama, const Settings& settings,
             const GoOn& go_on = {}, Least least = Least::one_sample);

/// The same in steps, for programs that show intermediate results.
class Tracing {
public:
    /// Scene and panorama must outlive it. Throws as trace().
    Tracing(const scene::Scene& scene, const image::RadianceImage* panorama, const Settings& settings);
    ~Tracing();
    Tracing(const Tracing&) = delete;
    Tracing& operator=(const Tracing&) = delete;

    /// Traces until a limit is reached, or until `go_on` returns false after at least one tile; neither before
    /// `least` is complete. Returns whether a limit was reached. Stopping loses nothing: the samples are those of a
    /// trace() that was not stopped. Exceptions of `go_on` are passed on; afterwards the object cannot be used any
    /// more.
    bool advance(const GoOn& go_on, Least least);

    /// Whether each pixel has at least one sample.
    bool has_picture() const;

    /// The result so far. Requires has_picture().
    Result result() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace lambent::reference
