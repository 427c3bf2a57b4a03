#include "view/camera.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace lambent::view {
namespace {

// The margin around the scene, as a factor of its extent in the picture.
constexpr float frame_margin = 1.1f;

// The nearest distance, along `camera.back` from the box's centre, at which all its corners are in the picture.
float fitting_distance(const Camera& camera, const glm::vec3& half, float aspect)
{
    const float up = std::tan(camera.vertical_fov / 2.0f), right = up * aspect;
    float distance = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p(corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y,
                          corner & 4 ? half.z : -half.z);
        const float across = std::fabs(glm::dot(p, camera.right)) / right;
        const float along = std::fabs(glm::dot(p, camera.up)) / up;
        distance = std::max(distance, frame_margin * std::max(across, along) + glm::dot(p, camera.back));
    }
    return distance;
}

} // namespace

Camera orbit_camera(const scene::Bounds& bounds, const Orbit& orbit, float vertical_fov, float aspect)
{
    const bool empty = !(bounds.low.x <= bounds.high.x);
    const glm::vec3 centre = empty ? glm::vec3(0.0f) : 0.5f * (bounds.low + bounds.high);
    glm::vec3 half = empty ? glm::vec3(1.0f) : 0.5f * (bounds.high - bounds.low);
    if (half == glm::vec3(0.0f)) // a single point
        half = glm::vec3(1e-6f);
    const float sine = std::sin(orbit.elevation), cosine = std::cos(orbit.elevation);
    Camera camera;
    camera.back = {cosine * std::sin(orbit.azimuth), sine, cosine * std::cos(orbit.azimuth)};
    camera.right = {std::cos(orbit.azimuth), 0.0f, -std::sin(orbit.azimuth)};
    camera.up = glm::cross(camera.back, camera.right);
    camera.vertical_fov = vertical_fov;
    const float distance = orbit.distance > 0.0f ? orbit.distance : fitting_distance(camera, half, aspect);
    camera.position = centre + distance * camera.back;
    return camera;
}

Camera from_scene(const scene::Camera& camera)
{
    Camera result;
    result.right = glm::normalize(glm::vec3(camera.transform[0]));
    result.up = glm::normalize(glm::vec3(camera.transform[1]));
    result.back = glm::normalize(glm::vec3(camera.transform[2]));
    result.position = glm::vec3(camera.transform[3]);
    result.vertical_fov = camera.vertical_fov;
    result.vertical_size = camera.vertical_size;
    result.aspect = camera.aspect;
    result.near = camera.near;
    result.far = camera.far;
    return result;
}

RayMap ray_map(const Camera& camera, int width, int height)
{
    const bool orthographic = camera.vertical_fov <= 0.0f;
    float extent = orthographic ? camera.vertical_size : 2.0f * std::tan(camera.vertical_fov / 2.0f);
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    if (camera.aspect > aspect)
        extent *= camera.aspect / aspect;
    const float pixel = extent / static_cast<float>(height);
    const glm::vec3 dx = pixel * camera.right, dy = -pixel * camera.up;
    const glm::vec3 corner = -0.5f * (static_cast<float>(width) * dx + static_cast<float>(height) * dy);
    RayMap map;
    map.origin = camera.position;
    map.direction = -camera.back;
    map.near = camera.near;
    map.far = camera.far;
    if (orthographic) {
        map.origin += corner;
        map.origin_dx = dx;
        map.origin_dy = dy;
    } else {
        map.direction += corner;
        map.direction_dx = dx;
        map.direction_dy = dy;
    }
    return map;
}

} // namespace lambent::view
