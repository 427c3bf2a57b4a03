// A scene as plain data: what is there, where, made of what, lit by what. Immutable once loaded.
// Right-handed, +Y up, metres. Colours are linear RGB with Rec. 709 primaries. Angles are radians.
#pragma once

#include <glm/ext/vector_double3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "image/image.h"
#include "scene/material.h"
#include "scene/texcoord_sets.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace lambent::scene {

/// Triangles, or points and lines, with one material. Per-vertex arrays have one entry a vertex, or none where marked
/// optional. Corners are below positions.size(). Points and lines are one pixel wide in every picture
/// (view/widened_scene.h), of a double-sided material; without normals it is unlit. [glTF 2.0, 3.9.6]
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;    ///< unit length; optional for points and lines
    std::vector<glm::vec4> tangents;   ///< optional; xyz unit length, w the sign of the bitangent
    TexcoordSets texcoords;            ///< each optional
    std::vector<glm::vec4> colors;     ///< optional; linear RGBA, multiplies the base colour
    std::vector<glm::uvec3> triangles; ///< counter-clockwise seen from the front
    std::vector<glm::uvec2> lines;     ///< from one corner to another
    std::vector<std::uint32_t> points;
    int material = 0; ///< index into Scene::materials
};

/// A mesh placed in the world.
struct Instance {
    int mesh = 0;              ///< index into Scene::meshes
    int material = -1;         ///< index into Scene::materials; -1: the mesh's own
    glm::mat4 transform{1.0f}; ///< world from mesh; affine, finite, not singular; det < 0: mirrored
};

/// A camera of the file. Looks along its -Z, +Y up.
struct Camera {
    std::string name;           ///< the node's, or the camera's own where the node has none
    glm::mat4 transform{1.0f};  ///< world from camera; rotation and translation only
    float vertical_fov = 0.0f;  ///< radians; 0 for an orthographic camera
    float vertical_size = 0.0f; ///< metres seen from bottom to top, orthographic only
    float aspect = 0.0f;        ///< width / height of what is to be seen at least; 0: nothing is said of it
    float near = 0.0f,
          far = std::numeric_limits<float>::infinity(); ///< metres ahead between which things are seen
};

enum class LightKind : std::uint8_t { directional, point, spot };

/// A light without size. [KHR_lights_punctual]
struct Light {
    LightKind kind = LightKind::point;
    glm::vec3 intensity{1.0f};              ///< lux (directional) or candela (point, spot), times colour
    glm::vec3 position{0.0f};               ///< point and spot
    glm::vec3 direction{0.0f, -1.0f, 0.0f}; ///< the way the light travels, unit length; directional and spot
    float range = std::numeric_limits<float>::infinity(); ///< metres; nothing is lit beyond
    float inner_cone = 0.0f;       ///< spot: full intensity within this angle from the axis
    float outer_cone = 0.7853982f; ///< spot: none outside this angle
};

struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};
};

/// An animation of the scene's file.
struct AnimationInfo {
    std::string name;     ///< its own, else animation0, animation1, ... by its place in the file
    double seconds = 0.0; ///< duration: the time of its last key; finite, not negative
};

/// All places are relative to `origin`: a scene that lies far from the world's own keeps its digits.
struct Scene {
    glm::dvec3 origin{0.0}; ///< in the world, metres; 0 but for scenes that are far away
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Material> materials;      ///< never empty
    std::vector<image::CodeImage> images; ///< RGBA codes
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<AnimationInfo> animations;
    std::optional<Bounds> rest_bounds; ///< of a scene at a moment of an animation: its bounds without
};

/// Index into the scene's materials of what an instance of it shows: its own, else its mesh's.
std::size_t material_of(const Scene& scene, const Instance& instance);

/// Whether it holds points or lines.
bool has_lines(const Mesh& mesh);
bool has_lines(const Scene& scene);

/// Whether it shows anything.
bool is_empty(const Mesh& mesh);

/// Number of triangles drawn: instances counted each time, points and lines as two.
std::size_t triangle_count(const Scene& scene);

/// How many points and lines are drawn: instances counted each time.
struct LineCount {
    std::size_t points = 0, lines = 0;
};
LineCount line_count(const Scene& scene);

/// Smallest box around every instance, relative to the scene's origin; low > high for an empty scene. Where looking at every
/// vertex of every instance would take seconds, meshes that are shown often count as their boxes.
Bounds bounds(const Scene& scene);

/// Where the origin of a scene in this box should be, from where it is now: near its middle where that is further away than 64
/// times half its diagonal, else where it is. Nearer, floats of 24 bits still place things to 2^-18 of the scene's size, less
/// than a hundredth of a pixel.
glm::dvec3 better_origin(const Bounds& bounds);

/// The box that a camera frames: rest_bounds, if something is in it, so that pictures of one animation are seen from one
/// place; else the scene's own.
Bounds framed_bounds(const Scene& scene);

} // namespace lambent::scene
