// The light of single pixels, path-traced.
#pragma once

#include "reference/tracer.h"

#include <glm/ext/vector_double3.hpp>

#include <cstdint>
#include <memory>

namespace lambent::reference {

/// The estimated light of a pixel: the mean of its samples, linear RGB before exposure.
struct PixelEstimate {
    glm::dvec3 radiance{0.0};
    glm::dvec3 variance{0.0}; ///< of `radiance`, unbiased; infinite after one sample
    double coverage = 0.0;    ///< share of the samples that met a surface, 0 to 1
    int broken = 0;           ///< samples that were not finite and count as black
};

/// Traces pixels of a picture one by one, as trace() does all.
class PixelTracer {
public:
    /// Scene and panorama must outlive it. Of the settings, the limits and the seed have no effect. Throws as trace().
    PixelTracer(const scene::Scene& scene, const image::RadianceImage* panorama, const Settings& settings);
    ~PixelTracer();
    PixelTracer(const PixelTracer&) = delete;
    PixelTracer& operator=(const PixelTracer&) = delete;

    struct Pixel {
        int x = 0, y = 0;
        int samples = 1;        ///< at least 1
        std::uint32_t seed = 0; ///< estimates of different seeds, or of different pixels, are independent
    };

    /// The light of a pixel of the picture: that of trace() for this seed and number of samples, without `adaptive`. May
    /// be called by any number of threads.
    PixelEstimate estimate(const Pixel& pixel) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace lambent::reference
