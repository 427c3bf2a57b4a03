#include "scene/transform.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace lambent::scene {

bool is_invertible(const glm::dmat4& transform)
{
    const glm::dmat3 linear(transform);
    const double determinant = std::abs(glm::determinant(linear));
    const double box = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    return determinant > 1e-12 * box && determinant > 1e-36 && determinant < 1e36;
}

} // namespace lambent::scene
