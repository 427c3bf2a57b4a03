// Two numbers evenly spread over [0, 1) as the points that samplers take. For .cpp files, after material_in_double.h.
#pragma once

#include "equations/in_double.h"

#include <glm/ext/vector_double2.hpp>

#include <cmath>
#include <numbers>

namespace lambent::reference {

/// (xi2, cos 2 pi xi1, sin 2 pi xi1), as the samplers of src/equations want it.
inline in_double::vec3 cap_point(const glm::dvec2& u)
{
    return {u.y, std::cos(2.0 * std::numbers::pi * u.x), std::sin(2.0 * std::numbers::pi * u.x)};
}

} // namespace lambent::reference
