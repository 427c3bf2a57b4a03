// A scene as plain data: meshes, instances, materials, images, cameras and lights. Immutable once loaded.
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

/// Triangles, or points and lines, with one material. Per-vertex arrays have one entry per vertex; those marked
/// optional may be empty. Vertex indices are below positions.size(). Points and lines are drawn one pixel wide
/// (view/widened_scene.h); their material is double-sided, and unlit if the mesh has no normals. [glTF 2.0, 3.9.6]
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;    ///< unit length; optional for points and lines
    std::vector<glm::vec4> tangents;   ///< optional; xyz unit length, w the sign of the bitangent
    TexcoordSets texcoords;            ///< each optional
    std::vector<glm::vec4> colors;     ///< optional; linear RGBA, multiplies the base colour
    std::vector<glm::uvec3> triangles; ///< counter-clockwise seen from the front
    std::vector<glm::uvec2> lines;     ///< from one vertex to another
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
    float vertical_size = 0.0f; ///< metres from bottom to top of the view, orthographic only
    float aspect = 0.0f;        ///< width / height of the view that every picture contains; 0: not given
    float near = 0.0f,
          far =
              std::numeric_limits<float>::infinity(); ///< clipping distances along the view direction, metres
};

enum class LightKind : std::uint8_t { directional, point, spot };

/// A light without size. [KHR_lights_punctual]
struct Light {
    LightKind kind = LightKind::point;
    glm::vec3 intensity{1.0f};              ///< lux (directional) or candela (point, spot), times colour
    glm::vec3 position{0.0f};               ///< point and spot
    glm::vec3 direction{0.0f, -1.0f, 0.0f}; ///< in which the light travels, unit length; directional and spot
    float range = std::numeric_limits<float>::infinity(); ///< metres; surfaces beyond are not lit
    float inner_cone = 0.0f;       ///< spot: full intensity within this angle from the axis
    float outer_cone = 0.7853982f; ///< spot: no light outside this angle
};

struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};
};

/// An animation of the scene's file.
struct AnimationInfo {
    std::string name;     ///< the file's, else animation0, animation1, ... by index
    double seconds = 0.0; ///< duration: the time of its last key; finite, not negative
};

/// All positions are relative to `origin`, so that scenes far from the world's origin keep their precision in floats.
struct Scene {
    glm::dvec3 origin{0.0}; ///< in the world, metres; 0 except for scenes far from the world's origin
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Material> materials;      ///< never empty
    std::vector<image::CodeImage> images; ///< RGBA codes
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<AnimationInfo> animations;
    std::optional<Bounds> rest_bounds; ///< for a scene posed by an animation: its bounds at rest
};

/// Index of an instance's material in Scene::materials: its own, else its mesh's.
std::size_t material_of(const Scene& scene, const Instance& instance);

/// Whether the mesh, or any mesh of the scene, holds points or lines.
bool has_lines(const Mesh& mesh);
bool has_lines(const Scene& scene);

/// Whether the mesh has no triangles, points or lines.
bool is_empty(const Mesh& mesh);

/// Number of triangles drawn by all instances; a point or line counts as two.
std::size_t triangle_count(const Scene& scene);

/// Numbers of points and lines drawn by all instances.
struct LineCount {
    std::size_t points = 0, lines = 0;
};
LineCount line_count(const Scene& scene);

/// Smallest box around all instances, relative to the scene's origin; low > high for an empty scene. If the vertices
/// of all instances are too many to visit, meshes with many instances are replaced by their boxes; the result may then
/// be larger.
Bounds bounds(const Scene& scene);

/// The offset by which to move the origin of a scene with these bounds: to near their centre if that is further away
/// than 64 times half their diagonal, else 0. Up to that distance, floats of 24 bits resolve 2^-18 of the scene's
/// size, less than a hundredth of a pixel.
glm::dvec3 better_origin(const Bounds& bounds);

/// The box that an orbit camera frames: rest_bounds unless it is empty, so that the camera does not move with an
/// animation; else the scene's bounds.
Bounds framed_bounds(const Scene& scene);

} // namespace lambent::scene
