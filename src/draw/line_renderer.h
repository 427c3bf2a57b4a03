// Points and lines for renderers that know triangles.
#pragma once

#include "draw/renderer.h"

#include <memory>

namespace lambent::draw {

/// `renderer` itself, which was made for the scene, or, where the scene has points and lines, one around it that turns them
/// into triangles for each picture. The scene must outlive it.
std::unique_ptr<Renderer> with_lines(std::unique_ptr<Renderer> renderer, const scene::Scene& scene);

} // namespace lambent::draw
