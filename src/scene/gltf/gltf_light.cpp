#include "scene/gltf/gltf_light.h"

#include "scene/gltf_document/gltf_losses.h"
#include "scene/index.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lambent::scene {
namespace {

constexpr double half_turn = 3.14159265358979323846;

// Rotation and translation of a transform: the Z axis keeps its direction, Y stays in the plane of Z and Y. Nothing if
// these axes have collapsed.
std::optional<glm::mat4> rigid(const glm::dmat4& transform)
{
    const glm::dvec3 z(transform[2]);
    const double z_length = glm::length(z);
    const glm::dvec3 unit_z = z / z_length;
    const glm::dvec3 y = glm::dvec3(transform[1]) - unit_z * glm::dot(unit_z, glm::dvec3(transform[1]));
    const double y_length = glm::length(y);
    if (!(z_length > 0.0) || !(y_length > 1e-9 * glm::length(glm::dvec3(transform[1]))))
        return std::nullopt;
    const glm::dvec3 unit_y = y / y_length;
    return glm::mat4(glm::dmat4(glm::dvec4(glm::cross(unit_y, unit_z), 0.0), glm::dvec4(unit_y, 0.0),
                                glm::dvec4(unit_z, 0.0), transform[3]));
}

Camera read_lens(const Document& document, int index)
{
    if (index < 0 || at(index) >= document.model.cameras.size())
        document.fail("camera ", index, " does not exist");
    const gltf::Camera& source = document.model.cameras[at(index)];
    if (source.is_broken)
        throw told_already();
    Camera camera;
    camera.name = source.name;
    if (source.type == "perspective") {
        if (!(source.perspective->yfov > 0.0 && source.perspective->yfov < half_turn))
            document.fail("camera ", index, ": yfov ", source.perspective->yfov, " is not between 0 and pi");
        camera.vertical_fov = static_cast<float>(source.perspective->yfov);
    } else {
        // ymag is half the height of the view; a negative one would flip the picture and is read as positive.
        camera.vertical_size = static_cast<float>(2.0 * std::abs(source.orthographic->ymag));
        if (!(camera.vertical_size > 0.0f && std::isfinite(camera.vertical_size)))
            document.fail("camera ", index, ": ymag ", source.orthographic->ymag, " is not a valid size");
    }
    return camera;
}

// Whether these are valid clipping planes; far may be infinite.
bool are_planes(double nearest, double near, double far)
{
    return std::isfinite(near) && near >= nearest && far > near;
}

// Reads the aspect and the clipping planes. [glTF 2.0, 3.10.3]
void read_extent(const Document& document, int index, Losses& losses, Camera& camera)
{
    const gltf::Camera& source = document.model.cameras[at(index)];
    const auto warn = [&](const char* what) {
        losses.add(text(document.file, ": camera ", index, ": ", what));
    };
    const bool perspective = source.type == "perspective";
    const gltf::Perspective p = source.perspective.value_or(gltf::Perspective());
    const gltf::Orthographic o = source.orthographic.value_or(gltf::Orthographic());
    const double aspect = perspective ? p.aspect_ratio : std::abs(o.xmag / o.ymag);
    if (!perspective && (o.xmag < 0.0 || o.ymag < 0.0))
        warn("a negative xmag or ymag would mirror the picture: read as positive");
    if (static_cast<float>(aspect) > 0.0f && std::isfinite(static_cast<float>(aspect)))
        camera.aspect = static_cast<float>(aspect);
    else if (!perspective || aspect != 0.0)
        warn(perspective ? "aspectRatio is not a positive number: ignored"
                         : "xmag is not a valid size: ignored");
    const double near = perspective ? p.znear : o.znear;
    const double given = perspective ? p.zfar : o.zfar;
    const double far = perspective && given == 0.0 ? std::numeric_limits<double>::infinity() : given;
    if (!are_planes(0.0, near, far)) {
        warn("znear and zfar are not valid clipping planes: ignored");
        return;
    }
    camera.near = static_cast<float>(near);
    camera.far = static_cast<float>(far);
}

glm::vec3 light_intensity(const Document& document, const gltf::Light& light, const std::string& name)
{
    glm::vec3 intensity;
    for (int channel = 0; channel < 3; ++channel) {
        intensity[channel] = static_cast<float>(light.intensity * light.color[at(channel)]);
        if (!(intensity[channel] >= 0.0f && std::isfinite(intensity[channel])))
            document.fail(name, ": its intensity times colour is negative or too large");
    }
    return intensity;
}

void read_cones(const gltf::Spot& spot, const std::string& name, Losses& losses, Light& light)
{
    const double most = half_turn / 2.0;
    const double outer = std::min(spot.outer_cone_angle, most);
    if (!(outer > 0.0))
        refuse(name, ": outerConeAngle ", spot.outer_cone_angle, " is not above 0");
    const double inner = std::clamp(spot.inner_cone_angle, 0.0, outer);
    if (inner != spot.inner_cone_angle || spot.outer_cone_angle > most + 1e-6)
        losses.add(text(name, ": cone angles ", spot.inner_cone_angle, " and ", spot.outer_cone_angle,
                        " are not 0 <= inner <= outer <= pi/2"),
                   text(inner, " and ", outer, " are used"));
    light.inner_cone = static_cast<float>(inner);
    light.outer_cone = static_cast<float>(outer);
}

Light read_light(const Document& document, int index, Losses& losses)
{
    const std::string name = text("light ", index);
    if (index < 0 || at(index) >= document.model.lights.size())
        document.fail(name, " does not exist");
    const gltf::Light& source = document.model.lights[at(index)];
    if (source.is_broken)
        throw told_already();
    Light light;
    if (source.type == "directional")
        light.kind = LightKind::directional;
    else if (source.type == "point")
        light.kind = LightKind::point;
    else if (source.type == "spot")
        light.kind = LightKind::spot;
    else
        document.fail(name, ": type \"", printable(source.type), "\" is not known");
    light.intensity = light_intensity(document, source, name);
    if (source.range < 0.0)
        losses.add(text(document.file, ": ", name, ": range ", source.range, " is negative"), "ignored");
    if (source.range > 0.0)
        light.range = static_cast<float>(source.range);
    if (light.kind == LightKind::spot)
        read_cones(source.spot, text(document.file, ": ", name), losses, light);
    return light;
}

} // namespace

std::vector<Camera> read_cameras(const Document& document, const NodeTree& nodes, Warnings& warnings)
{
    std::vector<Camera> cameras;
    Losses losses(document.file, warnings);
    for (const int node : nodes.drawn) {
        const gltf::Node& source = document.model.nodes[at(node)];
        if (source.camera < 0)
            continue;
        Camera camera;
        if (!losses.spare("the camera is left out", [&] { camera = read_lens(document, source.camera); }))
            continue;
        read_extent(document, source.camera, losses, camera);
        if (!source.name.empty())
            camera.name = source.name;
        if (camera.name.empty())
            camera.name = text("camera", cameras.size());
        const auto transform = rigid(nodes.world[at(node)]);
        if (!transform) {
            losses.add(text(document.file, ": node ", node, ": its camera has no direction: left out"));
            continue;
        }
        camera.transform = *transform;
        cameras.push_back(std::move(camera));
    }
    return cameras;
}

std::vector<Light> read_lights(const Document& document, const NodeTree& nodes, Warnings& warnings)
{
    std::vector<Light> lights;
    Losses losses(document.file, warnings);
    for (const int node : nodes.drawn) {
        const int index = document.model.nodes[at(node)].light;
        if (index < 0 || nodes.hidden[at(node)])
            continue;
        Light light;
        if (!losses.spare("the light is left out", [&] { light = read_light(document, index, losses); }))
            continue;
        const glm::dmat4& world = nodes.world[at(node)];
        light.position = glm::vec3(glm::dvec3(world[3]));
        const glm::dvec3 backward(world[2]);
        const double length = glm::length(backward);
        if (length > 0.0) {
            light.direction = glm::vec3(-backward / length);
        } else if (light.kind != LightKind::point) {
            losses.add(text(document.file, ": node ", node, ": its light has no direction: left out"));
            continue;
        }
        lights.push_back(light);
    }
    return lights;
}

} // namespace lambent::scene
