// Cube geometry, one texel at a time, in double.
#pragma once

#include "environment/chain/cube_chain.h"

namespace lambent::environment {

/// Unit direction of the point (s, t) of a face, in [-1, 1]; values beyond continue the face's plane.
struct Direction {
    double x, y, z;
};
Direction cube_direction(int face, double s, double t);

/// The face that a direction meets, and the point on it, s and t in [-1, 1].
struct FacePosition {
    int face;
    double s, t;
};
FacePosition cube_position(const Direction& d);

/// Solid angle of a texel of a face of `size` texels a side, in steradians.
double cube_texel_solid_angle(int size, int x, int y);

/// Fills the borders of a level from the neighbouring faces, at the directions that continue each face's plane, so that
/// bilinear lookups are continuous across edges and corners.
void fill_borders(CubeChain& chain, int level);

} // namespace lambent::environment
