// The backend for CPUs: visibility by Embree, shading in SIMD lanes.
#pragma once

#include "draw/renderer.h"
#include "scene/scene.h"

#include <memory>

namespace lambent::draw {

/// A renderer of `scene`, which must outlive it. Work runs in the caller's TBB arena. Drawing throws Error(no_device)
/// if the processor cannot run Embree or memory does not suffice.
std::unique_ptr<Renderer> make_cpu_renderer(const scene::Scene& scene);

} // namespace lambent::draw
