// Surfaces that shine, as lights: points on them drawn in proportion to what they send out.
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
    /// All triangles of materials with an emissive factor; unlit ones are pictures, not lamps. Textures are not looked
    /// at: a lamp that is mostly black is drawn too often, no more.
    explicit Emitters(const scene::Scene& scene);

    bool empty() const { return triangles_.empty(); }

    /// A point, as if a ray had met it, on either side, and its density per square metre.
    struct Drawn {
        trace::Hit hit;
        glm::dvec3 position{0.0}, normal{0.0}; ///< normal of the counter-clockwise side
        double density = 0.0;
    };
    /// `u`: which triangle, and where on it.
    Drawn draw(const std::array<double, 3>& u) const;

    /// Density of draw() on the surfaces of an instance, per square metre; 0 if it does not shine.
    double density(std::uint32_t instance) const { return densities_[instance]; }

private:
    struct Triangle {
        std::uint32_t instance, index;
        glm::vec3 corner, edge1, edge2; ///< in the world
        glm::vec3 normal;               ///< unit
    };
    std::vector<Triangle> triangles_;
    DiscreteDistribution<double> choice_; ///< of a triangle, by the light that it sends out
    std::vector<double> densities_;       ///< per instance
};

} // namespace lambent::reference
