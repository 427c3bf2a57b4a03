#include "scene/builtin/shapes.h"

#include "equations/in_double.h"

#include <cmath>
#include <cstdint>

namespace lambent::scene {
namespace {

// Direction at `east` (0 to 1 around, from -Z) and `south` (0 to 1 from +Y down). The panorama's mapping is mirrored,
// since panoramas are seen from inside.
glm::dvec3 direction(double east, double south)
{
    const in_double::vec3 d = in_double::direction_from_equirectangular({0.25 - east, south});
    return {d.x, d.y, d.z};
}

} // namespace

Mesh make_sphere(float radius, int segments, int rings)
{
    Mesh mesh;
    for (int ring = 0; ring <= rings; ++ring) {
        const bool pole = ring == 0 || ring == rings;
        for (int segment = 0; segment <= segments; ++segment) {
            const double south = static_cast<double>(ring) / rings;
            // The last column repeats the first exactly; a pole has one vertex for each of its triangles.
            const double place = segment == segments ? 0.0 : static_cast<double>(segment) / segments;
            const glm::dvec3 normal =
                pole ? glm::dvec3(0.0, ring == 0 ? 1.0 : -1.0, 0.0) : direction(place, south);
            mesh.positions.push_back(glm::vec3(normal * static_cast<double>(radius)));
            mesh.normals.push_back(glm::vec3(normal));
            mesh.texcoords[0].push_back(glm::vec2((segment + (pole ? 0.5 : 0.0)) / segments, south));
        }
    }
    const auto vertex = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(ring * (segments + 1) + segment);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            const std::uint32_t west = vertex(ring, segment);
            const std::uint32_t east = vertex(ring, segment + 1);
            const std::uint32_t south_west = vertex(ring + 1, segment);
            const std::uint32_t south_east = vertex(ring + 1, segment + 1);
            if (ring != 0)
                mesh.triangles.push_back({west, ring + 1 == rings ? south_west : south_east, east});
            if (ring + 1 != rings)
                mesh.triangles.push_back({west, south_west, south_east});
        }
    }
    return mesh;
}

Mesh make_plane(float half_size, int segments)
{
    Mesh mesh;
    for (int row = 0; row <= segments; ++row) {
        for (int column = 0; column <= segments; ++column) {
            const glm::vec2 uv(static_cast<float>(column) / static_cast<float>(segments),
                               static_cast<float>(row) / static_cast<float>(segments));
            mesh.positions.push_back(
                {half_size * (2.0f * uv.x - 1.0f), 0.0f, half_size * (2.0f * uv.y - 1.0f)});
            mesh.normals.push_back({0.0f, 1.0f, 0.0f});
            mesh.texcoords[0].push_back(uv);
        }
    }
    for (int row = 0; row < segments; ++row) {
        for (int column = 0; column < segments; ++column) {
            const auto far_left = static_cast<std::uint32_t>(row * (segments + 1) + column);
            const auto near_left = far_left + static_cast<std::uint32_t>(segments) + 1;
            mesh.triangles.push_back({far_left, near_left, near_left + 1});
            mesh.triangles.push_back({far_left, near_left + 1, far_left + 1});
        }
    }
    return mesh;
}

} // namespace lambent::scene
