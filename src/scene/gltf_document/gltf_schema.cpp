// The part of the glTF 2.0 schema that the loader relies on, as tables. [glTF 2.0, 5]
#include "scene/gltf_document/gltf_json.h"

#include "scene/gltf_document/gltf_checker.h"

#include <nlohmann/json.hpp>

namespace lambent::scene {
namespace {

using nlohmann::json;

constexpr Property one(const char* name, Kind kind, Need need = Need::optional)
{
    return {name, kind, need};
}

constexpr Property vector(const char* name, std::size_t length)
{
    return {name, Kind::numbers, Need::optional, length};
}

constexpr Property nested(const char* name, const Shape& shape, Need need = Need::optional)
{
    return {name, Kind::object, need, 0, &shape};
}

// tinygltf spends up to two kilobytes on an object that is three bytes in the file: each list has a limit.
constexpr Property list(const char* name, const Shape& shape, const char* element, std::size_t most)
{
    return {name, Kind::objects, Need::optional, 0, &shape, element, most};
}

constexpr Need required = Need::required;
constexpr Shape nothing{};

constexpr Property asset_properties[] = {one("version", Kind::word, required), one("minVersion", Kind::word)};
constexpr Shape asset{asset_properties};

constexpr Property scene_properties[] = {one("name", Kind::word), one("nodes", Kind::indices)};
constexpr Shape scene{scene_properties};

constexpr Property node_light_properties[] = {one("light", Kind::index, required)};
constexpr Shape node_light{node_light_properties};
constexpr Property instancing_properties[] = {one("attributes", Kind::index_map)};
constexpr Shape instancing{instancing_properties};
constexpr Property visibility_properties[] = {one("visible", Kind::flag)};
constexpr Shape visibility{visibility_properties};
constexpr Property node_extension_properties[] = {nested("KHR_lights_punctual", node_light),
                                                  nested("EXT_mesh_gpu_instancing", instancing),
                                                  nested("KHR_node_visibility", visibility)};
constexpr Shape node_extensions{node_extension_properties};
constexpr Property node_properties[] = {one("name", Kind::word),
                                        one("children", Kind::indices),
                                        one("camera", Kind::index),
                                        one("mesh", Kind::index),
                                        one("skin", Kind::index),
                                        vector("matrix", 16),
                                        vector("rotation", 4),
                                        vector("scale", 3),
                                        vector("translation", 3),
                                        vector("weights", 0),
                                        nested("extensions", node_extensions)};
constexpr Shape node{node_properties};

constexpr Property primitive_extension_properties[] = {nested("KHR_draco_mesh_compression", nothing)};
constexpr Shape primitive_extensions{primitive_extension_properties};
constexpr Property primitive_properties[] = {one("attributes", Kind::index_map, required),
                                             one("indices", Kind::index),
                                             one("material", Kind::index),
                                             one("mode", Kind::index),
                                             one("targets", Kind::index_maps),
                                             nested("extensions", primitive_extensions)};
constexpr Shape primitive{primitive_properties};
constexpr Property mesh_properties[] = {one("name", Kind::word), vector("weights", 0),
                                        list("primitives", primitive, "primitive", 1'000'000)};
constexpr Shape mesh{mesh_properties};

constexpr Property sparse_indices_properties[] = {one("bufferView", Kind::index, required),
                                                  one("byteOffset", Kind::index),
                                                  one("componentType", Kind::index, required)};
constexpr Shape sparse_indices_shape{sparse_indices_properties};
constexpr Property sparse_values_properties[] = {one("bufferView", Kind::index, required),
                                                 one("byteOffset", Kind::index)};
constexpr Shape sparse_values_shape{sparse_values_properties};
constexpr Property sparse_properties[] = {one("count", Kind::index, required),
                                          nested("indices", sparse_indices_shape, required),
                                          nested("values", sparse_values_shape, required)};
constexpr Shape sparse{sparse_properties};
constexpr Property accessor_properties[] = {one("bufferView", Kind::index),
                                            one("byteOffset", Kind::size),
                                            one("componentType", Kind::index, required),
                                            one("normalized", Kind::flag),
                                            one("count", Kind::size, required),
                                            one("type", Kind::word, required),
                                            nested("sparse", sparse)};
constexpr Shape accessor{accessor_properties};

constexpr Property buffer_view_properties[] = {
    one("buffer", Kind::index, required), one("byteOffset", Kind::size),
    one("byteLength", Kind::size, required), one("byteStride", Kind::size)};
constexpr Shape buffer_view{buffer_view_properties};
constexpr Property buffer_properties[] = {one("byteLength", Kind::size, required), one("uri", Kind::word)};
constexpr Shape buffer{buffer_properties};

constexpr Property image_properties[] = {one("uri", Kind::word), one("mimeType", Kind::word),
                                         one("bufferView", Kind::index), one("name", Kind::word)};
constexpr Shape image{image_properties};
constexpr Property texture_properties[] = {one("sampler", Kind::index), one("source", Kind::index)};
constexpr Shape texture{texture_properties};
constexpr Property sampler_properties[] = {one("magFilter", Kind::index), one("minFilter", Kind::index),
                                           one("wrapS", Kind::index), one("wrapT", Kind::index)};
constexpr Shape sampler{sampler_properties};

constexpr Property transform_properties[] = {vector("offset", 2), one("rotation", Kind::number),
                                             vector("scale", 2), one("texCoord", Kind::index)};
constexpr Shape transform{transform_properties};
constexpr Property texture_extension_properties[] = {nested("KHR_texture_transform", transform)};
constexpr Shape texture_extensions{texture_extension_properties};
constexpr Property texture_info_properties[] = {
    one("index", Kind::index, required), one("texCoord", Kind::index), one("scale", Kind::number),
    one("strength", Kind::number), nested("extensions", texture_extensions)};
constexpr Shape texture_info{texture_info_properties};
constexpr Property metallic_roughness_properties[] = {
    vector("baseColorFactor", 4), nested("baseColorTexture", texture_info),
    one("metallicFactor", Kind::number), one("roughnessFactor", Kind::number),
    nested("metallicRoughnessTexture", texture_info)};
constexpr Shape metallic_roughness_shape{metallic_roughness_properties};
constexpr Property strength_properties[] = {one("emissiveStrength", Kind::number)};
constexpr Shape strength{strength_properties};
constexpr Property material_extension_properties[] = {nested("KHR_materials_emissive_strength", strength),
                                                      nested("KHR_materials_unlit", nothing)};
constexpr Shape material_extensions{material_extension_properties};
constexpr Property material_properties[] = {one("name", Kind::word),
                                            nested("pbrMetallicRoughness", metallic_roughness_shape),
                                            nested("normalTexture", texture_info),
                                            nested("occlusionTexture", texture_info),
                                            nested("emissiveTexture", texture_info),
                                            vector("emissiveFactor", 3),
                                            one("alphaMode", Kind::word),
                                            one("alphaCutoff", Kind::number),
                                            one("doubleSided", Kind::flag),
                                            nested("extensions", material_extensions)};
constexpr Shape material{material_properties};

constexpr Property skin_properties[] = {one("inverseBindMatrices", Kind::index), one("skeleton", Kind::index),
                                        one("joints", Kind::indices, required)};
constexpr Shape skin{skin_properties};

constexpr Property target_properties[] = {one("node", Kind::index), one("path", Kind::word, required)};
constexpr Shape target{target_properties};
constexpr Property channel_properties[] = {one("sampler", Kind::index, required),
                                           nested("target", target, required)};
constexpr Shape channel{channel_properties};
constexpr Property key_properties[] = {one("input", Kind::index, required), one("interpolation", Kind::word),
                                       one("output", Kind::index, required)};
constexpr Shape keys{key_properties};
constexpr Property animation_properties[] = {one("name", Kind::word),
                                             list("channels", channel, "channel", 1'000'000),
                                             list("samplers", keys, "sampler", 1'000'000)};
constexpr Shape animation{animation_properties};

constexpr Property perspective_properties[] = {one("aspectRatio", Kind::number),
                                               one("yfov", Kind::number, required), one("zfar", Kind::number),
                                               one("znear", Kind::number, required)};
constexpr Shape perspective{perspective_properties};
constexpr Property orthographic_properties[] = {
    one("xmag", Kind::number, required), one("ymag", Kind::number, required),
    one("zfar", Kind::number, required), one("znear", Kind::number, required)};
constexpr Shape orthographic{orthographic_properties};
constexpr Property camera_properties[] = {one("name", Kind::word), one("type", Kind::word, required),
                                          nested("perspective", perspective),
                                          nested("orthographic", orthographic)};
constexpr Shape camera{camera_properties};

constexpr Property spot_properties[] = {one("innerConeAngle", Kind::number),
                                        one("outerConeAngle", Kind::number)};
constexpr Shape spot{spot_properties};
constexpr Property light_properties[] = {one("name", Kind::word),    one("type", Kind::word, required),
                                         vector("color", 3),         one("intensity", Kind::number),
                                         one("range", Kind::number), nested("spot", spot)};
constexpr Shape light{light_properties};
constexpr Property lights_properties[] = {list("lights", light, "light", 20'000)};
constexpr Shape lights{lights_properties};
constexpr Property extension_properties[] = {nested("KHR_lights_punctual", lights)};
constexpr Shape extensions{extension_properties};

constexpr Property root_properties[] = {nested("asset", asset, required),
                                        one("scene", Kind::index),
                                        list("scenes", scene, "scene", 20'000),
                                        list("nodes", node, "node", 200'000),
                                        list("meshes", mesh, "mesh", 200'000),
                                        list("accessors", accessor, "accessor", 1'000'000),
                                        list("bufferViews", buffer_view, "bufferView", 1'000'000),
                                        list("buffers", buffer, "buffer", 200'000),
                                        list("images", image, "image", 20'000),
                                        list("textures", texture, "texture", 20'000),
                                        list("samplers", sampler, "sampler", 20'000),
                                        list("materials", material, "material", 20'000),
                                        list("skins", skin, "skin", 20'000),
                                        list("cameras", camera, "camera", 20'000),
                                        list("animations", animation, "animation", 20'000),
                                        nested("extensions", extensions),
                                        one("extensionsUsed", Kind::words),
                                        one("extensionsRequired", Kind::words)};
constexpr Shape root{root_properties};

} // namespace

std::optional<std::size_t> top_level_limit(std::string_view name)
{
    constexpr std::size_t most_words = 10'000;
    const Property* property = find_property(root, name);
    if (property == nullptr)
        return std::nullopt;
    return property->kind == Kind::objects ? property->most : most_words;
}

std::string check_schema(json& document, const std::string& file, Losses& losses)
{
    return check_shape(document, root, {file, losses});
}

} // namespace lambent::scene
