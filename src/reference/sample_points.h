// Converts pairs of numbers in [0, 1) to the points that sampling functions take. Included by .cpp files only, after
// material_in_double.h.
#pragma once

#include "equations/in_double.h"

#include <glm/ext/vector_double2.hpp>

#include <cmath>
#include <numbers>

namespace lambent::reference {

/// The point (xi2, cos 2 pi xi1, sin 2 pi xi1) that the sampling functions of src/equations take, for u = (xi1, xi2).
inline in_double::vec3 cap_point(const glm::dvec2& u)
{
    return {u.y, std::cos(2.0 * std::numbers::pi * u.x), std::sin(2.0 * std::numbers::pi * u.x)};
}

} // namespace lambent::reference
