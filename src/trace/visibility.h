// Nearest intersections of rays with a scene, by Embree.
#pragma once

#include "trace/embree.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace lambent::trace {

/// One ray, from `near` to `far` in multiples of its direction.
struct Ray {
    glm::vec3 origin{0.0f}, direction{0.0f};
    float near = 0.0f, far = std::numeric_limits<float>::infinity();
};

/// Rays, sixteen at a time, one array per component. A ray starts at `near`, in multiples of its direction; all end at
/// `far`.
struct Rays {
    /// Resizes the arrays to `count` rays, whose components are then undefined.
    void resize(std::size_t count);
    std::size_t size() const { return near.size(); }
    Ray at(std::size_t index) const;

    std::vector<float> origin[3], direction[3], near;
    float far = std::numeric_limits<float>::infinity();
};

/// The intersection of a ray with a triangle, at origin + distance * direction. u and v are the barycentric
/// coordinates of the triangle's vertices 1 and 2.
struct Hit {
    static constexpr std::uint32_t nothing = ~0u;
    float distance = 0.0f;
    float u = 0.0f, v = 0.0f;
    std::uint32_t instance = nothing; ///< index into Scene::instances
    std::uint32_t triangle = 0;       ///< index into its mesh's triangles
    glm::vec3 normal{0.0f};           ///< unit geometric normal in the world, of the counter-clockwise side
    bool front = true;                ///< whether the ray met that side

    bool found() const { return instance != nothing; }
};

/// The scene's triangles in a bounding volume hierarchy. The scene must outlive it.
class Visibility {
public:
    explicit Visibility(const scene::Scene& scene);
    Visibility(const Visibility&) = delete;
    Visibility& operator=(const Visibility&) = delete;

    /// A box around all triangles; low above high if there are none.
    scene::Bounds bounds() const;

    /// Limit of the coordinates of a ray's origin and direction, beyond which Embree aborts the program. It is lower
    /// in scenes with very small instances of a shared mesh. Rays beyond the limit, rays with a negative start and
    /// rays with components that are not numbers meet nothing.
    static constexpr float furthest = 1.0e18f;

    /// Writes the nearest hit of each ray to hits[0], hits[1], ... Neighbouring rays should be nearly parallel.
    void trace(const Rays& rays, Hit* hits) const;

    /// The nearest hit of one ray, for rays without nearly parallel neighbours.
    Hit nearest(const Ray& ray) const;

    /// Whether the ray meets anything; takes about half as long.
    bool is_blocked(const Ray& ray) const;

private:
    /// A hit as Embree reports it: geometry and instance (either may be invalid), and the normal, not normalised.
    struct Found {
        unsigned geometry, instance, triangle;
        float distance, u, v;
        glm::vec3 normal, direction;
    };
    Hit hit_of(const Found& found) const;
    bool takes(const Ray& ray) const;
    void load_packet(const Rays& rays, std::size_t first, RTCRayHit16& packet_rays, int* valid) const;
    void add_instance(std::uint32_t index, const std::vector<int>& uses);
    RTCScene mesh_scene(int mesh);

    const scene::Scene& scene_;
    EmbreeDevice device_; ///< outlives its scenes
    EmbreeScene world_;
    std::vector<EmbreeScene> mesh_scenes_; ///< of each mesh that several instances share; null for others
    float reach_ = furthest;               ///< largest coordinate of an origin or direction
    std::vector<glm::mat3> normals_;       ///< per instance: world from Embree's normal, up to its length
};

} // namespace lambent::trace
