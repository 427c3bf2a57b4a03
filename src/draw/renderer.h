// The one interface of all backends.
#pragma once

#include "draw/frame.h"
#include "draw/settings.h"
#include "environment/environment.h"
#include "scene/scene.h"

#include <functional>
#include <string>

namespace lambent::draw {

/// Draws one scene, prepared once, as often as wanted, and at other moments.
class Renderer {
public:
    virtual ~Renderer() = default;

    /// The scene seen by the settings' camera under an environment (null: darkness). `progress`, if any, is called
    /// with the done fraction, from any thread, one call at a time.
    virtual Frame draw(const environment::Environment* environment, const Settings& settings,
                       const std::function<void(float)>& progress = {}) = 0;

    /// From now on draws the same scene at another moment: with as many instances, meshes and materials, of which the
    /// materials are the same; its images are not looked at, those of the first scene stay. `scene` must outlive further
    /// drawing, as the first must. The work is done by the next draw.
    virtual void pose(const scene::Scene& scene) = 0;

    /// Name of the backend and of what it runs on, for people: {"cpu", "AVX2, 2 threads"}.
    struct Device {
        std::string backend, description;
    };
    virtual Device device() const = 0;
};

} // namespace lambent::draw
