// Cube geometry, one texel at a time, in double.
#pragma once

#include "environment/chain/cube_chain.h"

namespace lambent::environment {

/// Unit direction of the point (s, t) in [-1, 1] of a face; beyond it, the face's plane goes on.
struct Direction {
    double x, y, z;
};
Direction cube_direction(int face, double s, double t);

/// Face that a direction meets, and where on it.
struct FacePosition {
    int face;
    double s, t;
};
FacePosition cube_position(const Direction& d);

/// Solid angle of a texel of a face of `size` texels a side, in steradians.
double cube_texel_solid_angle(int size, int x, int y);

/// Fills the borders of a level from the neighbouring faces, where the plane of a face goes on into them, and so that
/// bilinear lookups are continuous across edges and corners.
void fill_borders(CubeChain& chain, int level);

} // namespace lambent::environment
