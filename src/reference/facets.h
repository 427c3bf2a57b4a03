// GGX facets in double, of a base or of a lobe over it.
#pragma once

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

namespace lambent::reference {

/// Facets around a normal, over a diffuse base, for one view direction (equations/energy.glsl).
struct Facets {
    glm::dvec3 normal{0.0};    ///< unit
    glm::dvec3 view{0.0};      ///< unit, towards the viewer
    glm::dvec3 base{0.0};      ///< linear RGB
    double metalness = 0.0;    ///< 0 to 1
    glm::dvec2 alpha{1.0};     ///< roughness along the tangent and along the bitangent
    glm::dvec3 tangent{0.0};   ///< any direction but the normal; not read if both alphas are equal
    double compensation = 1.0; ///< for light scattered more than once, 0 or 1
    glm::dvec2 albedo{0.0};    ///< the two parts of the directional albedo for this view

    /// BRDF times the cosine, RGB per steradian; 0 below the surface.
    glm::dvec3 value(const glm::dvec3& light) const;

    /// Directional albedo for this view, of facets and diffuse base together, RGB.
    glm::dvec3 share() const;

    /// Density of draw() at a direction, per steradian.
    double density(const glm::dvec3& light) const;

    /// Samples a visible facet and returns the direction that it mirrors, which may be below the surface. Both numbers
    /// of `u` are in [0, 1).
    glm::dvec3 draw(const glm::dvec2& u) const;

    bool is_stretched() const { return alpha.x != alpha.y; }
};

} // namespace lambent::reference
