// The one interface of all backends.
#pragma once

#include "draw/frame.h"
#include "draw/settings.h"
#include "environment/environment.h"

#include <functional>
#include <string>

namespace lambent::draw {

/// Draws one scene, prepared once, as often as wanted.
class Renderer {
public:
    virtual ~Renderer() = default;

    /// The scene seen by the settings' camera under an environment (null: darkness). `progress`, if any, is called
    /// with the done fraction, from any thread, one call at a time.
    virtual Frame draw(const environment::Environment* environment, const Settings& settings,
                       const std::function<void(float)>& progress = {}) = 0;

    /// Name of the backend and of what it runs on, for people: {"cpu", "AVX2, 2 threads"}.
    struct Device {
        std::string backend, description;
    };
    virtual Device device() const = 0;
};

} // namespace lambent::draw
