// The one interface of all backends.
#pragma once

#include "draw/frame.h"
#include "draw/settings.h"
#include "environment/environment.h"
#include "scene/scene.h"

#include <functional>
#include <memory>
#include <string>

namespace lambent::draw {

/// A picture that is drawn bit by bit.
class Drawing {
public:
    virtual ~Drawing() = default;

    /// Asked with the done fraction whether to go on, from any thread, one call at a time: once for every part that is
    /// done, also for those that were still being drawn when it said no.
    using GoOn = std::function<bool(float)>;

    /// Draws on until the picture is whole, which it returns, or `go_on`, if any, says false; at least a little. The
    /// renderer must be in the pose that it had at the start; meanwhile it may have drawn others. What `go_on` throws
    /// is passed on; then this is of no more use.
    virtual bool advance(const GoOn& go_on) = 0;

    /// The whole picture, once.
    virtual Frame take() = 0;
};

/// Draws one scene, prepared once, as often as wanted, and at other moments.
class Renderer {
public:
    virtual ~Renderer() = default;

    /// The scene seen by the settings' camera under an environment (null: darkness), which must not change after
    /// it was first drawn under: devices keep it. Renderer and environment must outlive the drawing.
    virtual std::unique_ptr<Drawing> start(const environment::Environment* environment,
                                           const Settings& settings) = 0;

    /// The same at once. `progress`, if any, is called as Drawing::GoOn.
    Frame draw(const environment::Environment* environment, const Settings& settings,
               const std::function<void(float)>& progress = {});

    /// From now on draws the same scene at another moment: with as many instances and materials, of which the materials are
    /// the same; its images are not looked at, those of the first scene stay. `scene` must outlive further drawing, as the
    /// first must. The work is done by the next draw.
    virtual void pose(const scene::Scene& scene) = 0;

    /// Name of the backend and of what it runs on, for people: {"cpu", "AVX2, 2 threads"}.
    struct Device {
        std::string backend, description;
    };
    virtual Device device() const = 0;
};

} // namespace lambent::draw
