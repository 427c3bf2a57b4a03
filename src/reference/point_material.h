// Materials at a point, in double.
#pragma once

#include <glm/ext/vector_double3.hpp>

namespace lambent::reference {

/// The parameters of shading/material/parameters.h, linear.
struct PointMaterial {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture)                                    \
    glm::dvec3 name{value};                                                                                  \
    double alpha = value;
#define COLOR(name, number, value, object, key, texture) glm::dvec3 name{value};
#define SCALAR(name, number, value, object, key, texture, channel) double name = value;
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) double name = value;
#define STRENGTH(name, factor, number, value, object, key, texture, channel) double name = value;
#include "shading/material/parameters.h"
};

/// Parameters of the report's model.
struct PointPhong {
    glm::dvec3 diffuse{0.0};  ///< Kd
    glm::dvec3 specular{0.0}; ///< Ks
    double exponent = 1.0;    ///< alpha of the report
};

} // namespace lambent::reference
