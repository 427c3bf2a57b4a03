// Materials at a point: the light that they reflect from one direction into another, and sampling of directions.
#pragma once

#include "reference/bases.h"
#include "reference/facets.h"
#include "reference/point_material.h"
#include "view/picture.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include <vector>

namespace lambent::reference {

/// A lobe over the base. Its parameters are in the material; it has its own normal.
struct PointLayer {
    int number = 1;         ///< in shading/lobes/layers.h
    glm::dvec3 normal{0.0}; ///< unit shading normal, on the viewer's side
};

/// A surface point as Surfaces::at() finds it.
struct Surface {
    glm::dvec3 position{0.0};
    glm::dvec3 geometric{0.0}; ///< unit normal of the triangle, on the viewer's side
    glm::dvec3 normal{0.0};    ///< unit shading normal, on the viewer's side
    glm::dvec3 view{0.0};      ///< unit, towards the origin of the ray
    PointMaterial material;
    PointPhong phong;
    std::vector<PointLayer> layers; ///< lobes of strength above 0, from the lowest up
    bool unlit = false;
};

/// Radiance that the surface emits towards its viewer: its material's emission, attenuated by the lobes over the
/// base, or its colour if it is unlit.
glm::dvec3 emitted_by(const Surface& surface, bool energy_compensation);

/// Reflection of light by a surface point towards its viewer. The surface must outlive it.
class Reflection {
public:
    Reflection(const Surface& surface, view::Model model, bool energy_compensation);

    /// BRDF times the cosine, RGB per steradian; 0 below the surface.
    glm::dvec3 value(const glm::dvec3& light) const;

    /// Density of draw() at a direction, per steradian.
    double density(const glm::dvec3& light) const;

    /// Samples a direction of incoming light: by visible normals for glossy lobes, by the cosine for the diffuse part.
    /// It may be below the surface, where value() is 0.
    glm::dvec3 draw(const glm::dvec2& u) const;

    /// Share of white light from everywhere that is reflected to the viewer (directional albedo), RGB: exact but for
    /// the Phong model, which has no closed form, and by whose colours it is estimated.
    glm::dvec3 albedo() const;

    /// Whether light from most directions is reflected to the viewer.
    bool is_wide() const;

private:
    /// A lobe over the base.
    struct Layer {
        Facets facets;
        double there = 1.0;   ///< strength, 0 to 1
        glm::dvec3 left{0.0}; ///< share of light that it leaves to the lobes below
        double chance = 0.0;  ///< probability that draw() samples it rather than the lobes below
    };
    void add(const PointLayer& layer, double compensation, double& below);

    const Surface& surface_;
    AnyBase base_;
    std::vector<Layer> layers_; ///< from the lowest up
};

} // namespace lambent::reference
