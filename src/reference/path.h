// Light along one ray of sight, by one random path.
#pragma once

#include "reference/emitters.h"
#include "reference/environment_light.h"
#include "reference/lens.h"
#include "reference/sampler.h"
#include "reference/surface.h"
#include "trace/visibility.h"
#include "view/picture.h"

#include <glm/ext/vector_double3.hpp>

#include <span>

namespace lambent::reference {

/// Which of the two ways of finding the environment's light are used. One alone is for checking the other.
enum class Strategy { both, lights_only, reflections_only };

/// What all paths of a picture share.
struct World {
    const trace::Visibility* visibility = nullptr;
    const trace::Visibility* lines = nullptr; ///< seen by the camera alone; null: none
    const Surfaces* surfaces = nullptr;
    const EnvironmentLight* environment = nullptr; ///< null: darkness
    const Emitters* emitters = nullptr;            ///< null: none
    std::vector<scene::Light> lights;
    view::Model model = view::Model::ggx;
    bool energy_compensation = true;
    view::Background background;
    bool has_unlit = false; ///< whether there are surfaces without lighting
    int bounces = 8;        ///< 0: light that arrives directly, without shadows
    Strategy strategy = Strategy::both;
};

/// Radiance, and whether a surface was seen (0 or 1).
struct Sight {
    glm::dvec3 radiance{0.0};
    double coverage = 0.0;
    bool unlit = false; ///< the surface seen is one without lighting
};

/// One sample of what a ray of sight sees: an unbiased estimate, noise and all.
Sight trace_path(const World& world, const SightRay& ray, SampleSequence& sampler);

} // namespace lambent::reference
