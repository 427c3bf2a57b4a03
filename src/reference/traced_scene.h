// A scene and its light, made ready for paths.
#pragma once

#include "reference/tracer.h"
#include "trace/visibility.h"
#include "view/widened_scene.h"

namespace lambent::reference {

/// Owns all data that paths refer to. Not copied or moved, because its parts refer to each other.
class TracedScene {
public:
    /// Of `settings` only the description of the picture, the bounces and the strategy matter. Scene and panorama (RGB;
    /// null: black) must outlive it. Throws as trace().
    TracedScene(const scene::Scene& scene, const image::RadianceImage* panorama, const Settings& settings);
    TracedScene(const TracedScene&) = delete;
    TracedScene& operator=(const TracedScene&) = delete;

    const World& world() const { return world_; }

private:
    const lambent::trace::Visibility visibility_;
    const std::optional<view::WidenedScene> lines_;
    std::optional<lambent::trace::Visibility> seen_lines_;
    const Surfaces surfaces_;
    std::optional<EnvironmentLight> environment_;
    const Emitters emitters_;
    World world_;
};

/// The camera rays of a picture.
Lens lens_of(const Settings& settings);

/// A pixel of a picture, with its random numbers: pixels of one seed have independent ones.
struct SeededPixel {
    int x = 0, y = 0;
    std::uint32_t seed = 0;
};

/// Sample `number` of a pixel, of the replicate `number` % replicates (samples/estimate.h). Its radiance may be NaN or
/// infinite. `first` as of trace_path.
Sight sample_pixel(const World& world, const Lens& lens, const SeededPixel& pixel, int number,
                   FirstSurface* first = nullptr);

/// Whether the radiance is finite; else it becomes black.
bool mend(Sight& sight);

} // namespace lambent::reference
