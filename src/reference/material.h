// Materials at a point: how much light they send from one direction into another, and where to look for it.
#pragma once

#include "view/picture.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

namespace lambent::reference {

/// What find_surface knows of a point. Colours are linear.
struct Surface {
    glm::dvec3 position{0.0};
    glm::dvec3 geometric{0.0}; ///< unit normal of the triangle, on the viewer's side
    glm::dvec3 normal{0.0};    ///< unit shading normal, on the viewer's side
    glm::dvec3 view{0.0};      ///< unit, towards where the ray came from
    glm::dvec3 base{0.0};      ///< ggx: base colour; phong: Kd
    glm::dvec3 specular{0.0};  ///< phong: Ks
    double gloss = 1.0;        ///< ggx: alpha = perceptual_roughness^2; phong: exponent
    double metalness = 0.0;
    double opacity = 1.0;
    glm::dvec3 emitted{0.0};
    bool unlit = false;
};

/// The reflection of a surface point towards its viewer.
class Reflection {
public:
    Reflection(const Surface& surface, view::Model model, bool energy_compensation);

    /// BRDF times the cosine, RGB per steradian; 0 below the surface.
    glm::dvec3 value(const glm::dvec3& light) const;

    /// Density of draw() at a direction, per steradian.
    double density(const glm::dvec3& light) const;

    /// A direction light may come from: by visible normals for the glossy part, by the cosine for the diffuse part.
    /// May be below the surface, where value() is 0.
    glm::dvec3 draw(const glm::dvec2& u) const;

    /// Whether light from most directions is reflected to the viewer.
    bool is_wide() const;

private:
    double glossy_density(const glm::dvec3& light) const;
    glm::dvec3 draw_glossy(const glm::dvec2& u) const;

    const Surface& surface_;
    view::Model model_;
    double compensation_;
    glm::dvec2 albedo_{0.0}; ///< ggx: the two parts of the directional albedo
    double glossy_share_ = 1.0;
    double diffuse_; ///< luminance of what is reflected so
    double NV_;
};

/// The two parts of the directional albedo of GGX (equations/energy.glsl) at a cosine and alpha.
glm::dvec2 directional_albedo(double NV, double alpha);

} // namespace lambent::reference
