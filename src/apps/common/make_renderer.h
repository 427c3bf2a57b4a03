// The backend that a command line asks for.
#pragma once

#include "apps/options/arguments.h"
#include "draw/renderer.h"
#include "scene/scene.h"

#include <functional>
#include <memory>
#include <string>

namespace lambent::cli {

struct RendererChoice {
    Backend backend = Backend::automatic;
    bool cache = true; ///< of a device's compiled shaders

    /// Told in one line why the processor draws though there is a device; with Backend::automatic alone.
    std::function<void(const std::string&)> warn;
};

/// The scene must outlive it. Backend::automatic: hardware where there is some and it works, else the processor.
/// Throws Error(no_device), with Backend::vulkan also where this program was built without it.
std::unique_ptr<draw::Renderer> make_renderer(const RendererChoice& choice, const scene::Scene& scene);

} // namespace lambent::cli
