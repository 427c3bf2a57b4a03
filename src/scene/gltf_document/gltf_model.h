// The JSON of a glTF as plain structs with glTF's defaults; indices are not resolved yet. The tables that check the
// JSON say which members its values fill (scene/gltf_document/gltf_schema.h).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::scene::gltf {

/// An index that is absent from the file.
inline constexpr int none = -1;

/// Replaces an index that could not be read: no element has this number.
inline constexpr int unreadable_index = 2147483647;

/// glTF's codes. [glTF 2.0, 5]
enum Component : int { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };
enum Mode : int { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };
enum Wrapping : int { clamp_to_edge = 33071, mirrored_repeat = 33648, repeat = 10497 };
enum Filter : int {
    nearest = 9728,
    linear = 9729,
    nearest_mipmap_nearest = 9984,
    linear_mipmap_nearest = 9985,
    nearest_mipmap_linear = 9986,
    linear_mipmap_linear = 9987
};

using Vec3 = std::array<double, 3>;
using Vec4 = std::array<double, 4>;

/// Indices of accessors by the names of attributes.
using AttributeMap = std::map<std::string, int>;

// `is_broken`: the element could not be read, which was reported; it stays in the list so that indices remain valid.

struct Asset {
    std::string version, min_version;
};

struct Scene {
    std::vector<int> nodes;
};

struct Node {
    std::string name;
    std::vector<int> children;
    int mesh = none, skin = none, camera = none;
    int light = none;           ///< KHR_lights_punctual
    bool visible = true;        ///< KHR_node_visibility
    std::vector<double> matrix; ///< 16 numbers, which replace the next three; or empty
    std::optional<Vec3> translation, scale;
    std::optional<Vec4> rotation;
    std::vector<double> weights;
    AttributeMap instances; ///< attributes of EXT_mesh_gpu_instancing
};

struct Primitive {
    AttributeMap attributes;
    std::vector<AttributeMap> targets;
    int indices = none, material = none;
    int mode = Mode::triangles;
    bool has_draco = false; ///< KHR_draco_mesh_compression, which is not read
    bool is_broken = false;
};

struct Mesh {
    std::vector<Primitive> primitives;
    std::vector<double> weights;
};

struct SparseIndices {
    int buffer_view = 0, byte_offset = 0, component_type = 0;
};

struct SparseValues {
    int buffer_view = 0, byte_offset = 0;
};

struct Sparse {
    int count = 0;
    SparseIndices indices;
    SparseValues values;
};

struct Accessor {
    int buffer_view = none; ///< none: zeros
    std::uint64_t byte_offset = 0, count = 0;
    int component_type = Component::f32;
    bool normalized = false;
    bool is_broken = false;
    std::string type = "SCALAR";
    std::optional<Sparse> sparse;
};

struct BufferView {
    int buffer = 0;
    std::uint64_t byte_offset = 0, byte_length = 0;
    std::uint64_t byte_stride = 0; ///< 0: elements are tightly packed
    bool is_broken = false;
};

struct Buffer {
    std::uint64_t byte_length = 0;
    std::optional<std::string> uri;
};

/// An image in PNG or JPEG, at either `uri` or `buffer_view`; with both or neither, it is left out.
struct Image {
    std::string name;
    std::string uri;
    int buffer_view = none;
    bool is_broken = false;
};

struct Texture {
    int sampler = none, source = none;
    bool is_broken = false;
};

struct Sampler {
    int mag_filter = none, min_filter = none;
    int wrap_s = Wrapping::repeat, wrap_t = Wrapping::repeat;
};

/// KHR_texture_transform
struct TextureTransform {
    std::array<double, 2> offset = {0.0, 0.0}, scale = {1.0, 1.0};
    double rotation = 0.0;
    std::optional<int> tex_coord;
};

/// How a material uses a texture.
struct TextureInfo {
    int index = none;
    int tex_coord = 0;
    std::optional<double> scale, strength; ///< of normal textures; of occlusion textures
    std::optional<TextureTransform> transform;
};

/// Factors and textures by their paths in the material's JSON, like "pbrMetallicRoughness/metallicFactor", which
/// scene/gltf_document/gltf_material_schema.cpp lists; only those that are in the file.
struct Material {
    std::string name;
    std::string alpha_mode = "OPAQUE";
    bool double_sided = false;
    bool unlit = false; ///< KHR_materials_unlit
    std::map<std::string_view, std::vector<double>> factors;
    std::map<std::string_view, TextureInfo> textures;
};

struct Skin {
    std::vector<int> joints;
    int inverse_bind_matrices = none;
    bool is_broken = false;
};

struct Perspective {
    double yfov = 0.0, znear = 0.0;
    double aspect_ratio = 0.0, zfar = 0.0; ///< 0: absent
};

struct Orthographic {
    double xmag = 0.0, ymag = 0.0, zfar = 0.0, znear = 0.0;
};

struct Camera {
    std::string name, type;
    std::optional<Perspective> perspective;   ///< present if `type` is "perspective"
    std::optional<Orthographic> orthographic; ///< present if `type` is "orthographic"
    bool is_broken = false;
};

struct Spot {
    double inner_cone_angle = 0.0, outer_cone_angle = 0.78539816339744831;
};

/// KHR_lights_punctual
struct Light {
    std::string type;
    Vec3 color = {1.0, 1.0, 1.0};
    double intensity = 1.0;
    double range = 0.0; ///< 0: unlimited
    Spot spot;
    bool is_broken = false;
};

struct AnimationTarget {
    int node = none; ///< none: an extension defines the target
    std::string path;
};

struct AnimationChannel {
    int sampler = 0;
    AnimationTarget target;
    bool is_broken = false;
};

struct AnimationSampler {
    int input = unreadable_index, output = unreadable_index; ///< accessors
    std::string interpolation = "LINEAR";
    bool is_broken = false;
};

struct Animation {
    std::string name;
    std::vector<AnimationChannel> channels;
    std::vector<AnimationSampler> samplers;
};

struct Model {
    Asset asset;
    int scene = none;
    std::vector<Scene> scenes;
    std::vector<Node> nodes;
    std::vector<Mesh> meshes;
    std::vector<Accessor> accessors;
    std::vector<BufferView> buffer_views;
    std::vector<Buffer> buffers;
    std::vector<Image> images;
    std::vector<Texture> textures;
    std::vector<Sampler> samplers;
    std::vector<Material> materials;
    std::vector<Skin> skins;
    std::vector<Camera> cameras;
    std::vector<Animation> animations;
    std::vector<Light> lights;
    std::vector<std::string> extensions_used, extensions_required;
};

} // namespace lambent::scene::gltf
