// Shared shading code of materials and lobes compiled in double, and conversions to its types. Included by .cpp files
// only: each gets its own copy.
#pragma once

#include "albedo/albedo_table.h"
#include "equations/in_double.h"
#include "reference/point_material.h"

#include <glm/ext/vector_double3.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function" // no file uses all of the shared code

namespace lambent::in_double {
namespace {

#include "shading/numbers.glsl"
#include "shading/material/material.glsl"
#include "shading/surface/pixel.glsl"
#include "shading/surface/surface.glsl"

inline Real albedo_entry(Real column, Real row, int part)
{
    return static_cast<Real>(
        albedo_table[2 * (static_cast<int>(row) * albedo_table_size + static_cast<int>(column)) + part]);
}

#include "shading/lobes/albedo.glsl"
#include "shading/lobes/layers.glsl"

static_assert(albedo_points == albedo_table_size);

} // namespace
} // namespace lambent::in_double

namespace lambent::reference {
namespace {

inline in_double::vec3 to_text(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

inline glm::dvec3 from_text(const in_double::vec3& v)
{
    return {v.x, v.y, v.z};
}

inline in_double::Material to_text(const PointMaterial& m)
{
    return {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) to_text(m.name), m.alpha,
#define COLOR(name, number, value, object, key, texture) to_text(m.name),
#define SCALAR(name, number, value, object, key, texture, channel) m.name,
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) m.name,
#define STRENGTH(name, factor, number, value, object, key, texture, channel) m.name,
#include "shading/material/parameters.h"
    };
}

inline PointMaterial from_text(const in_double::Material& m)
{
    return {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) from_text(m.name), m.alpha,
#define COLOR(name, number, value, object, key, texture) from_text(m.name),
#define SCALAR(name, number, value, object, key, texture, channel) m.name,
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) m.name,
#define STRENGTH(name, factor, number, value, object, key, texture, channel) m.name,
#include "shading/material/parameters.h"
    };
}

} // namespace
} // namespace lambent::reference

#pragma GCC diagnostic pop
