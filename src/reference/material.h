// Materials at a point: how much light they send from one direction into another, and where to look for it.
#pragma once

#include "reference/bases.h"
#include "reference/facets.h"
#include "reference/point_material.h"
#include "view/picture.h"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include <vector>

namespace lambent::reference {

/// A lobe over the base, of shading/lobes/layers.h: by its parameters, which are the material's, and its own normal.
struct PointLayer {
    int number = 1;
    glm::dvec3 normal{0.0}; ///< unit shading normal, on the viewer's side
};

/// What find_surface knows of a point.
struct Surface {
    glm::dvec3 position{0.0};
    glm::dvec3 geometric{0.0}; ///< unit normal of the triangle, on the viewer's side
    glm::dvec3 normal{0.0};    ///< unit shading normal, on the viewer's side
    glm::dvec3 view{0.0};      ///< unit, towards where the ray came from
    PointMaterial material;
    PointPhong phong;
    std::vector<PointLayer> layers; ///< those that are there, from the lowest up
    bool unlit = false;
};

/// Light that the surface sends by itself towards its viewer: what lobes over the base leave of its material's, or, where it is
/// unlit, its colour.
glm::dvec3 emitted_by(const Surface& surface, bool energy_compensation);

/// The reflection of a surface point towards its viewer.
class Reflection {
public:
    Reflection(const Surface& surface, view::Model model, bool energy_compensation);

    /// BRDF times the cosine, RGB per steradian; 0 below the surface.
    glm::dvec3 value(const glm::dvec3& light) const;

    /// Density of draw() at a direction, per steradian.
    double density(const glm::dvec3& light) const;

    /// A direction light may come from: by visible normals for glossy lobes, by the cosine for the diffuse part.
    /// May be below the surface, where value() is 0.
    glm::dvec3 draw(const glm::dvec2& u) const;

    /// Whether light from most directions is reflected to the viewer.
    bool is_wide() const;

private:
    /// A lobe over the base.
    struct Layer {
        Facets facets;
        double there = 1.0;   ///< how much of it there is
        glm::dvec3 left{0.0}; ///< what it leaves to those below
        double chance = 0.0;  ///< of being drawn from before those below
    };
    void add(const PointLayer& layer, double compensation, double& below);

    const Surface& surface_;
    AnyBase base_;
    std::vector<Layer> layers_; ///< from the lowest up
};

} // namespace lambent::reference
