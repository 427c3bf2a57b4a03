#include "trace/visibility.h"

#include "base/error.h"
#include "base/text.h"
#include "wide/instruction_sets.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace lambent::trace {
namespace {

constexpr std::size_t packet = 16;

// A mesh is not instanced if only rays from nearer than this, in metres, could be transformed into its space.
constexpr double least_reach = 1e9;

RTCGeometry triangles(RTCDevice device, const scene::Mesh& mesh, const glm::mat4& transform)
{
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
    auto* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(std::uint32_t), mesh.triangles.size());
    if (!vertices || !indices)
        throw Error(Failure::no_device, "not enough memory for the scene's triangles");
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = transform * glm::vec4(mesh.positions[i], 1.0f);
        vertices[3 * i] = p.x, vertices[3 * i + 1] = p.y, vertices[3 * i + 2] = p.z;
    }
    std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * sizeof(glm::uvec3));
    rtcCommitGeometry(geometry);
    return geometry;
}

// `v` normalised, or zero. Scaled first, since squared normals of very large and very small triangles exceed the range
// of floats.
glm::vec3 unit(const glm::vec3& v)
{
    const float largest = std::max(std::fabs(v.x), std::max(std::fabs(v.y), std::fabs(v.z)));
    return largest > 0.0f ? glm::normalize(v / largest) : glm::vec3(0.0f);
}

// Whether the absolute values of all components are at most `most`; false for NaN.
bool within(const glm::vec3& v, float most)
{
    return std::fabs(v.x) <= most && std::fabs(v.y) <= most && std::fabs(v.z) <= most;
}

// Sets one lane of a packet. An inactive lane gets a valid ray that ends before it starts: where Embree splits a
// packet, or has no packets of sixteen, it recognises inactive lanes by their ends only.
void set_lane(RTCRay16& to, std::size_t lane, const Ray& ray, bool on)
{
    to.org_x[lane] = ray.origin.x, to.org_y[lane] = ray.origin.y, to.org_z[lane] = ray.origin.z;
    to.dir_x[lane] = ray.direction.x, to.dir_y[lane] = ray.direction.y, to.dir_z[lane] = ray.direction.z;
    to.tnear[lane] = ray.near;
    to.tfar[lane] = on ? ray.far : -std::numeric_limits<float>::infinity();
    to.time[lane] = 0.0f;
    to.mask[lane] = ~0u;
    to.id[lane] = 0;
    to.flags[lane] = 0;
}

// Largest coordinate of rays that Embree can transform into the space of a mesh with this transform; 0 if that is not
// far beyond the mesh itself, or if the determinant is near the limits of floats.
float reach_into(const glm::mat4& transform)
{
    const double determinant = std::fabs(glm::determinant(glm::dmat3(transform)));
    if (!(determinant > 1e-30 && determinant < 1e30))
        return 0.0f;
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(transform));
    double longest = 0.0, away = 0.0;
    for (int row = 0; row < 3; ++row) {
        longest = std::max(longest, std::fabs(inverse[0][row]) + std::fabs(inverse[1][row]) +
                                        std::fabs(inverse[2][row]));
        away = std::max(away, std::fabs(static_cast<double>(transform[3][row])));
    }
    const double reach = static_cast<double>(Visibility::furthest) / longest - away;
    return reach > std::max(least_reach, 10.0 * away) ? static_cast<float>(reach) : 0.0f;
}

} // namespace

void Rays::resize(std::size_t count)
{
    near.resize(count);
    for (auto* axes : {&origin, &direction})
        for (auto& axis : *axes)
            axis.resize(count);
}

Ray Rays::at(std::size_t index) const
{
    return {{origin[0][index], origin[1][index], origin[2][index]},
            {direction[0][index], direction[1][index], direction[2][index]},
            near[index],
            far};
}

Visibility::Visibility(const scene::Scene& scene) : scene_(scene)
{
    const std::string& limit = wide::instruction_limit();
    device_.reset(rtcNewDevice(limit.empty() ? nullptr : ("isa=" + limit).c_str()));
    if (!device_)
        throw Error(Failure::no_device, "Embree cannot run on this processor");
    world_.reset(rtcNewScene(device_.get()));
    std::vector<int> uses(scene.meshes.size(), 0);
    for (const scene::Instance& instance : scene.instances)
        ++uses[static_cast<std::size_t>(instance.mesh)];
    mesh_scenes_.resize(scene.meshes.size());
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
        add_instance(i, uses);
    rtcCommitScene(world_.get());
    if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE)
        throw Error(Failure::no_device,
                    text("Embree cannot build the scene (error ", static_cast<int>(error), ")"));
}

// A mesh with one instance is stored in world space; a mesh with several is built once and instanced, except for
// instances so small or so far away that Embree could not transform rays into their space.
void Visibility::add_instance(std::uint32_t index, const std::vector<int>& uses)
{
    const scene::Instance& instance = scene_.instances[index];
    const scene::Mesh& mesh = scene_.meshes[static_cast<std::size_t>(instance.mesh)];
    if (mesh.triangles.empty()) {
        normals_.emplace_back(1.0f);
        return;
    }
    RTCGeometry geometry;
    const glm::mat3 linear(instance.transform);
    const float side = glm::determinant(linear) < 0.0f ? -1.0f : 1.0f;
    const float reach = reach_into(instance.transform);
    if (uses[static_cast<std::size_t>(instance.mesh)] > 1 && reach > 0.0f) {
        reach_ = std::min(reach_, reach);
        // Embree returns the normal in the mesh's space.
        normals_.push_back(glm::transpose(glm::inverse(linear)));
        geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry, mesh_scene(instance.mesh));
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &instance.transform[0][0]);
        rtcCommitGeometry(geometry);
    } else {
        // A mirroring transform reverses the winding of triangles, but not their front side. [glTF 2.0, 3.7.4]
        normals_.push_back(glm::mat3(side));
        geometry = triangles(device_.get(), mesh, instance.transform);
    }
    rtcAttachGeometryByID(world_.get(), geometry, index);
    rtcReleaseGeometry(geometry);
}

RTCScene Visibility::mesh_scene(int mesh)
{
    EmbreeScene& scene = mesh_scenes_[static_cast<std::size_t>(mesh)];
    if (!scene) {
        scene.reset(rtcNewScene(device_.get()));
        const RTCGeometry geometry =
            triangles(device_.get(), scene_.meshes[static_cast<std::size_t>(mesh)], glm::mat4(1.0f));
        rtcAttachGeometry(scene.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene.get());
    }
    return scene.get();
}

// Embree aborts the program on other rays.
bool Visibility::takes(const Ray& ray) const
{
    return within(ray.origin, reach_) && within(ray.direction, reach_) && ray.near >= 0.0f &&
           ray.far >= ray.near;
}

// Loads sixteen rays, or those that are left, into a packet.
void Visibility::load_packet(const Rays& rays, std::size_t first, RTCRayHit16& packet_rays, int* valid) const
{
    for (std::size_t lane = 0; lane < packet; ++lane) {
        const Ray ray = first + lane < rays.size() ? rays.at(first + lane) : Ray();
        const bool on = first + lane < rays.size() && takes(ray);
        valid[lane] = on ? -1 : 0;
        set_lane(packet_rays.ray, lane, on ? ray : Ray(), on);
        packet_rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
        packet_rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
}

scene::Bounds Visibility::bounds() const
{
    RTCBounds box{};
    rtcGetSceneBounds(world_.get(), &box);
    return {{box.lower_x, box.lower_y, box.lower_z}, {box.upper_x, box.upper_y, box.upper_z}};
}

void Visibility::trace(const Rays& rays, Hit* hits) const
{
    alignas(64) RTCRayHit16 rays16{};
    alignas(64) int valid[packet];
    for (std::size_t first = 0; first < rays.size(); first += packet) {
        load_packet(rays, first, rays16, valid);
        intersect16(valid, world_.get(), &rays16);
        const RTCRay16& ray = rays16.ray;
        const RTCHit16& hit = rays16.hit;
        for (std::size_t i = 0; i < std::min(packet, rays.size() - first); ++i)
            hits[first + i] = hit_of({hit.geomID[i],
                                      hit.instID[0][i],
                                      hit.primID[i],
                                      ray.tfar[i],
                                      hit.u[i],
                                      hit.v[i],
                                      {hit.Ng_x[i], hit.Ng_y[i], hit.Ng_z[i]},
                                      {ray.dir_x[i], ray.dir_y[i], ray.dir_z[i]}});
    }
}

Hit Visibility::nearest(const Ray& ray) const
{
    if (!takes(ray))
        return {};
    alignas(16) RTCRayHit one{};
    one.ray.org_x = ray.origin.x, one.ray.org_y = ray.origin.y, one.ray.org_z = ray.origin.z;
    one.ray.dir_x = ray.direction.x, one.ray.dir_y = ray.direction.y, one.ray.dir_z = ray.direction.z;
    one.ray.tnear = ray.near;
    one.ray.tfar = ray.far;
    one.ray.mask = ~0u;
    one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    one.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersect1(world_.get(), &one);
    return hit_of({one.hit.geomID,
                   one.hit.instID[0],
                   one.hit.primID,
                   one.ray.tfar,
                   one.hit.u,
                   one.hit.v,
                   {one.hit.Ng_x, one.hit.Ng_y, one.hit.Ng_z},
                   ray.direction});
}

bool Visibility::is_blocked(const Ray& ray) const
{
    if (!takes(ray))
        return false;
    alignas(16) RTCRay one{};
    one.org_x = ray.origin.x, one.org_y = ray.origin.y, one.org_z = ray.origin.z;
    one.dir_x = ray.direction.x, one.dir_y = ray.direction.y, one.dir_z = ray.direction.z;
    one.tnear = ray.near;
    one.tfar = ray.far;
    one.mask = ~0u;
    occluded1(world_.get(), &one);
    return one.tfar < 0.0f; // Embree sets it to minus infinity
}

Hit Visibility::hit_of(const Found& found) const
{
    Hit hit;
    if (found.geometry == RTC_INVALID_GEOMETRY_ID)
        return hit;
    hit.instance = found.instance != RTC_INVALID_GEOMETRY_ID ? found.instance : found.geometry;
    hit.distance = found.distance;
    hit.u = found.u;
    hit.v = found.v;
    hit.triangle = found.triangle;
    hit.normal = unit(normals_[hit.instance] * found.normal);
    hit.front = glm::dot(hit.normal, found.direction) < 0.0f;
    return hit;
}

} // namespace lambent::trace
