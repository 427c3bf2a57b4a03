// The interface of all backends.
#pragma once

#include "draw/frame.h"
#include "draw/settings.h"
#include "environment/environment.h"
#include "scene/scene.h"

#include <functional>
#include <memory>
#include <string>

namespace lambent::draw {

/// A picture that is drawn in steps.
class Drawing {
public:
    virtual ~Drawing() = default;

    /// Called with the fraction that is done; returns whether to go on. Called from any thread, one call at a time,
    /// once for every finished part, including parts that were being drawn when it returned false, and at times within a part.
    using GoOn = std::function<bool(float)>;

    /// Draws until the picture is complete or `go_on`, if set, returns false, but at least one part. Returns whether
    /// the picture is complete. The renderer must be in the pose of the start; it may have drawn other pictures in
    /// between. Exceptions from `go_on` are passed on; the drawing is then unusable.
    virtual bool advance(const GoOn& go_on) = 0;

    /// Moves the complete picture out; to be called once, and last.
    virtual Frame take() = 0;

    /// Lets advance() go on with `passes` more rounds of rays, 1 or more, after a complete picture with bounces. Then it is
    /// the picture of Settings::passes and these, to the byte. Throws Error(usage) without bounces.
    virtual void refine(int passes);

    /// Called often, by any thread; may throw to end what it is called from. Empty: nothing is asked.
    using Check = std::function<void()>;

    /// A copy of a complete picture that will be refined. Takes a while, and passes exceptions of `check` on without a
    /// change. Throws Error(usage) without bounces.
    virtual Frame picture(const Check& check) const;
};

/// Draws a scene, prepared once, any number of times and in other poses.
class Renderer {
public:
    virtual ~Renderer() = default;

    /// Starts a picture of the scene under an environment (null: darkness). An environment must not change after it was
    /// first used, because devices keep a copy. Renderer and environment must outlive the drawing.
    virtual std::unique_ptr<Drawing> start(const environment::Environment* environment,
                                           const Settings& settings) = 0;

    /// Draws a whole picture in one call. `progress`, if set, is called like Drawing::GoOn.
    Frame draw(const environment::Environment* environment, const Settings& settings,
               const std::function<void(float)>& progress = {});

    /// Changes to the same scene at another time: with as many instances, and the same materials. Its images are not
    /// read; those of the first scene are kept. Both scenes must outlive further drawing. The next draw does the work.
    virtual void pose(const scene::Scene& scene) = 0;

    /// Names of the backend and of its hardware, for display: {"cpu", "AVX2, 2 threads"}.
    struct Device {
        std::string backend, description;
    };
    virtual Device device() const = 0;
};

} // namespace lambent::draw
