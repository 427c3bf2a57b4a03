// Radiance along one camera ray, estimated by one random path.
#pragma once

#include "reference/emitters.h"
#include "reference/environment_light.h"
#include "reference/first_surface.h"
#include "reference/lens.h"
#include "reference/samples/sampler.h"
#include "reference/surface.h"
#include "trace/visibility.h"
#include "view/picture.h"

#include <glm/ext/vector_double3.hpp>

#include <span>

namespace lambent::reference {

/// Which strategies sample the light of the environment and of emissive surfaces: points on light sources, directions
/// of reflection, or both combined. Each alone serves to check the other.
enum class Strategy { both, lights_only, reflections_only };

/// Data shared by all paths of a picture.
struct World {
    const trace::Visibility* visibility = nullptr;
    const trace::Visibility* lines = nullptr; ///< points and lines, visible to camera rays only; null: none
    const Surfaces* surfaces = nullptr;
    const EnvironmentLight* environment = nullptr; ///< null: black
    const Emitters* emitters = nullptr;            ///< null: none
    std::vector<scene::Light> lights;
    view::Model model = view::Model::ggx;
    bool energy_compensation = true;
    view::Background background;
    bool has_unlit = false; ///< whether there are unlit surfaces
    int bounces = 8;        ///< 0: direct light only, without shadows
    Strategy strategy = Strategy::both;
};

/// Radiance along a camera ray, and whether the ray met a surface (0 or 1).
struct Sight {
    glm::dvec3 radiance{0.0};
    double coverage = 0.0;
    bool unlit = false; ///< whether that surface is unlit
};

/// One sample of the light along a camera ray: an unbiased, noisy estimate. `first`, if not null, receives what the ray
/// meets; the sample is the same.
Sight trace_path(const World& world, const SightRay& ray, SampleSequence& sampler,
                 FirstSurface* first = nullptr);

} // namespace lambent::reference
