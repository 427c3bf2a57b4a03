// A scene as a binary glTF, for programs that cannot make the built-in scenes.
#pragma once

#include "scene/scene.h"

#include <string>

namespace lambent::bench {

/// Positions, normals, triangles, instances and untextured materials.
void write_glb(const scene::Scene& scene, const std::string& path);

} // namespace lambent::bench
