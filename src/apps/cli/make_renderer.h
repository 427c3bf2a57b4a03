// The backend that a command line asks for.
#pragma once

#include "apps/cli/arguments.h"
#include "draw/renderer.h"
#include "scene/scene.h"

#include <memory>

namespace lambent::cli {

/// The scene must outlive it. Throws Error(no_device), with Backend::vulkan also where this program was built without it.
std::unique_ptr<draw::Renderer> make_renderer(const RenderArguments& arguments, const scene::Scene& scene);

} // namespace lambent::cli
