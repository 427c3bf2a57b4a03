// The reference: a picture by path tracing, and how exact it is.
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

/// What to trace and when to stop: at whichever limit comes first, but never before each pixel has one sample. Rounds of
/// 1, 2, 4, 8, 16 and ever more samples go over the whole picture, each round's tiles scattered over it.
struct Settings : view::Picture {
    int bounces =
        8; ///< 0: direct light, no shadows (what image based lighting approximates); 1: with shadows
    std::optional<glm::vec3> panorama_from; ///< all directions from here instead of the camera's picture
    Strategy strategy = Strategy::both;
    int samples = 1 << 20; ///< per pixel, on average
    double noise = 0.0;    ///< estimated relative RMSE over covered pixels, see Noise; 0: no limit
    /// Radiance above this counts as this in all that is said of noise: what is brighter than a display's white would
    /// outweigh everything else. Above 0.
    double cut = std::numeric_limits<double>::infinity();
    double seconds = std::numeric_limits<double>::infinity();
    /// Noisy parts get more samples than quiet ones. The numbers of samples then depend on what was seen, which pulls
    /// values towards less by a small part of the noise. [Kirk and Arvo 1991] Without it, none of that.
    bool adaptive = false;
    std::uint32_t seed = 0;
};

struct Progress {
    double done = 0.0;          ///< of the way to the first limit, 0 to 1
    std::optional<Noise> noise; ///< as of the last round, where it is known: see Film::noise
    double samples = 0.0;       ///< per pixel, likewise
    double seconds_left = 0.0;
};

struct Result {
    image::RadianceImage radiance; ///< RGBA before exposure and tone curve; alpha is coverage by surfaces
    image::RadianceImage variance; ///< RGB: of each value of `radiance`, not cut; infinite after one sample
    std::optional<Noise> noise;    ///< where it is known: see Film::noise
    double samples = 0.0;          ///< per pixel, on average
    std::uint64_t broken = 0;      ///< samples that were no number and count as black
    bool stopped = false;          ///< by `go_on`
};

/// Asked now and then, by one thread at a time, whether to go on.
using GoOn = std::function<bool(const Progress&)>;

/// What a tracing must have done before it may be stopped: nothing, or so many samples of each pixel; two tell the noise.
enum class Least { nothing, one_sample, two_samples };

/// Paths through the scene under a panorama (RGB, finite, not negative, 2x1 or more; null: darkness). After `go_on` says
/// false, what there is is returned, though not before `least` is done.
/// Same rays, and same box filter over pixels, as draw/. Throws Error(no_device) where Embree does not run.
Result trace(const scene::Scene& scene, const image::RadianceImage* panorama, const Settings& settings,
             const GoOn& go_on = {}, Least least = Least::one_sample);

/// The same bit by bit: for those who look at it meanwhile.
class Tracing {
public:
    /// Scene and panorama must outlive it. Throws as trace().
    Tracing(const scene::Scene& scene, const image::RadianceImage* panorama, const Settings& settings);
    ~Tracing();
    Tracing(const Tracing&) = delete;
    Tracing& operator=(const Tracing&) = delete;

    /// Goes on until a limit is reached, which it returns, or, at least one tile, until `go_on` says false; neither before
    /// `least` is done. Nothing is lost by stopping: the samples are those of a trace() that was not stopped. What `go_on` throws is
    /// passed on; then this is of no more use.
    bool advance(const GoOn& go_on, Least least);

    /// Whether each pixel has a sample.
    bool has_picture() const;

    /// What there is so far, once there is a picture.
    Result result() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace lambent::reference
