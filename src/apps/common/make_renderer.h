// The renderer of the backend that a command line asks for.
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
    bool cache = true; ///< keep a device's compiled shaders

    /// Gets one line when a device fails and the CPU draws instead; only with Backend::automatic.
    std::function<void(const std::string&)> warn;
};

/// The scene must outlive the renderer. Backend::automatic: a hardware device that works, else the CPU. Throws
/// Error(no_device), with Backend::vulkan also if this program was built without Vulkan.
std::unique_ptr<draw::Renderer> make_renderer(const RendererChoice& choice, const scene::Scene& scene);

} // namespace lambent::cli
