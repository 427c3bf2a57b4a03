// Emissive surfaces as light sources: points on them are sampled in proportion to the emitted light.
#pragma once

#include "reference/discrete_distribution.h"
#include "reference/surface.h"
#include "scene/scene.h"
#include "trace/visibility.h"

#include <glm/ext/vector_double3.hpp>

#include <array>
#include <vector>

namespace lambent::reference {

class Emitters {
public:
    /// Collects the triangles of all materials with an emissive factor that are not unlit. Emissive textures are
    /// ignored: a lamp whose texture is mostly black is only sampled more often than necessary.
    explicit Emitters(const scene::Scene& scene);

    bool empty() const { return triangles_.empty(); }

    /// A sampled point in the form of a ray's hit, and its density per square metre. The caller sets Hit::front, as
    /// both sides are possible.
    struct Drawn {
        trace::Hit hit;
        glm::dvec3 position{0.0}, normal{0.0}; ///< normal of the counter-clockwise side
        double density = 0.0;
    };
    /// Samples a triangle by u[0] and a point on it by u[1] and u[2].
    Drawn draw(const std::array<double, 3>& u) const;

    /// Density of draw() on the surfaces of an instance, per square metre; 0 if it emits nothing.
    double density(std::uint32_t instance) const { return densities_[instance]; }

private:
    struct Triangle {
        std::uint32_t instance, index;
        glm::vec3 corner, edge1, edge2; ///< in world space
        glm::vec3 normal;               ///< unit
    };
    std::vector<Triangle> triangles_;
    DiscreteDistribution<double> choice_; ///< of a triangle, by its emitted light
    std::vector<double> densities_;       ///< per square metre, for each instance
};

} // namespace lambent::reference
