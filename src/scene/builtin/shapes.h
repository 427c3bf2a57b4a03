// Simple shapes with exact normals.
#pragma once

#include "scene/scene.h"

namespace lambent::scene {

/// A sphere around the origin, smooth, +Y up. `segments` (3 or more) around, `rings` (2 or more) from pole to
/// pole; 2 * segments * (rings - 1) triangles, none of them degenerate. u runs eastwards from the back (-Z),
/// v from the north pole down, so that an image stands upright seen from outside. Material 0.
Mesh make_sphere(float radius, int segments, int rings);

/// A square at y = 0 facing +Y, from -half_size to half_size along X and Z, of segments x segments squares.
/// u along X, v along Z. Material 0.
Mesh make_plane(float half_size, int segments);

} // namespace lambent::scene
