// The backend that needs no GPU: Embree for what is seen, SIMD lanes for how it looks.
#pragma once

#include "draw/renderer.h"
#include "scene/scene.h"

#include <memory>

namespace lambent::draw {

/// A renderer of `scene`, which must outlive it. Work is spread over the calling TBB arena.
/// Throws Error(no_device) if the processor cannot run Embree or memory does not suffice.
std::unique_ptr<Renderer> make_cpu_renderer(const scene::Scene& scene);

} // namespace lambent::draw
