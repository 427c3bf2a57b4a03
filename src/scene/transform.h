// Checks of transforms.
#pragma once

#include <glm/ext/matrix_double4x4.hpp>
#include <glm/mat4x4.hpp>

namespace lambent::scene {

/// Whether an affine transform has a finite inverse in float arithmetic: its axes do not collapse into a plane, and
/// its scale lies between about 1e-12 and 1e12.
bool is_invertible(const glm::dmat4& transform);

} // namespace lambent::scene
