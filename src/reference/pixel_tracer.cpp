#include "reference/pixel_tracer.h"

#include "reference/traced_scene.h"

#include <limits>

namespace lambent::reference {

struct PixelTracer::Parts {
    TracedScene scene;
    Lens lens;
};

PixelTracer::PixelTracer(const scene::Scene& scene, const image::RadianceImage* panorama,
                         const Settings& settings)
    : parts_(new Parts{{scene, panorama, settings}, lens_of(settings)})
{
}

PixelTracer::~PixelTracer() = default;

PixelEstimate PixelTracer::estimate(const Pixel& pixel) const
{
    PixelEstimate result;
    std::array<Sums, 3> sums{};
    for (int i = 0; i < pixel.samples; ++i) {
        Sight sight = sample_pixel(parts_->scene.world(), parts_->lens, {pixel.x, pixel.y, pixel.seed}, i);
        result.broken += mend(sight) ? 0 : 1;
        result.coverage += sight.coverage / pixel.samples;
        for (int c = 0; c < 3; ++c)
            sums[static_cast<std::size_t>(c)][static_cast<std::size_t>(i % replicates)] +=
                static_cast<float>(sight.radiance[c]);
    }
    for (int c = 0; c < 3; ++c) {
        const Estimate channel = reference::estimate(sums[static_cast<std::size_t>(c)], pixel.samples,
                                                     std::numeric_limits<double>::infinity());
        result.radiance[c] = channel.mean;
        result.variance[c] = channel.variance;
    }
    return result;
}

} // namespace lambent::reference
