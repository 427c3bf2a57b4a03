#include "reference/emitters.h"

#include "image/luminance.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace lambent::reference {

Emitters::Emitters(const scene::Scene& scene)
{
    std::vector<double> light; // emitted by each triangle
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        const scene::Material& material = scene.materials[scene::material_of(scene, instance)];
        const double radiance = material.unlit ? 0.0 : image::luminance(&material.emissive.r);
        densities_.push_back(radiance);
        if (!(radiance > 0.0))
            continue;
        const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const float side = glm::determinant(glm::mat3(instance.transform)) < 0.0f ? -1.0f : 1.0f;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto corner = [&](int k) {
                return glm::vec3(instance.transform * glm::vec4(mesh.positions[mesh.triangles[t][k]], 1.0f));
            };
            const glm::vec3 a = corner(0), e1 = corner(1) - a, e2 = corner(2) - a,
                            across = glm::cross(e1, e2);
            const float twice_area = glm::length(across);
            if (!(twice_area > 0.0f) || !std::isfinite(twice_area))
                continue;
            triangles_.push_back({i, t, a, e1, e2, side / twice_area * across});
            light.push_back(radiance * 0.5 * static_cast<double>(twice_area));
        }
    }
    choice_ = DiscreteDistribution<double>(light);
    for (double& density : densities_)
        density = choice_.sum() > 0.0 ? density / choice_.sum() : 0.0;
}

Emitters::Drawn Emitters::draw(const std::array<double, 3>& u) const
{
    const Triangle& triangle = triangles_[choice_.draw(u[0]).index];
    // Uniform over the triangle. [Osada et al. 2002, "Shape distributions", 4.2]
    const double root = std::sqrt(u[1]), b = root * (1.0 - u[2]), c = root * u[2];
    Drawn drawn;
    drawn.hit.instance = triangle.instance;
    drawn.hit.triangle = triangle.index;
    drawn.hit.u = static_cast<float>(b);
    drawn.hit.v = static_cast<float>(c);
    drawn.hit.normal = triangle.normal;
    drawn.normal = triangle.normal;
    drawn.position =
        glm::dvec3(triangle.corner) + b * glm::dvec3(triangle.edge1) + c * glm::dvec3(triangle.edge2);
    drawn.density = densities_[triangle.instance];
    return drawn;
}

} // namespace lambent::reference
