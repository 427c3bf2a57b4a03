// Points and lines for renderers that draw only triangles.
#pragma once

#include "draw/renderer.h"

#include <memory>

namespace lambent::draw {

/// Returns `renderer`, which was made for `scene`, if the scene has no points and lines; else a renderer around it that
/// replaces them with triangles for each picture. The scene must outlive the result.
std::unique_ptr<Renderer> with_lines(std::unique_ptr<Renderer> renderer, const scene::Scene& scene);

} // namespace lambent::draw
