// The part of the glTF 2.0 schema that the loader relies on, as tables. [glTF 2.0, 5]
#include "scene/gltf_json.h"

#include "scene/gltf_message.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace lambent::scene {
namespace {

using nlohmann::json;

enum class Kind {
    flag,       ///< true or false
    word,       ///< a string
    words,      ///< strings
    number,     ///< one number that fits a float
    numbers,    ///< numbers, `length` of them (0: any number)
    index,      ///< 0 .. 2^31 - 1
    indices,    ///< indices, any number
    index_map,  ///< object of indices
    index_maps, ///< objects of indices
    size,       ///< 0 .. 2^53
    object,     ///< object of `shape`
    objects,    ///< objects of `shape`
};

struct Property;

struct Shape {
    std::span<const Property> properties;
};

enum class Need { optional, required };

struct Property {
    const char* name;
    Kind kind;
    Need need = Need::optional;
    std::size_t length = 0;
    const Shape* shape = nullptr;
    const char* element = nullptr; ///< of objects: what one is called in messages
    std::size_t most = 0;          ///< of objects: how many are read
};

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

// Where in the document: a chain of these on the stack, turned into words only for a message.
struct Place {
    const Place* outer = nullptr;
    std::string_view name;
    std::ptrdiff_t index = -1;
};

std::string describe(const Place& place)
{
    std::string words = place.outer ? describe(*place.outer) : std::string();
    if (place.name.empty())
        return words;
    if (!words.empty())
        words += ", ";
    words += place.name;
    return place.index < 0 ? words : text(words, " ", place.index);
}

class Checker {
public:
    explicit Checker(const std::string& file) : file_(file) {}

    void check_object(json& object, const Shape& shape, const Place& place) const;

private:
    [[noreturn]] void fail(const Place& place, const std::string& reason) const
    {
        const std::string words = describe(place);
        refuse(file_, ": ", words, words.empty() ? "" : ": ", reason);
    }

    void check_value(json& value, const Property& property, const Place& place) const;
    void check_unsigned(json& value, double most, const Property& property, const Place& place) const;
    void check_number(json& value, const Property& property, const Place& place) const;
    void check_index_map(json& value, const Property& property, const Place& place) const;
    json::array_t& array(json& value, const Property& property, const Place& place) const;

    const std::string& file_;
};

const Property* find(const Shape& shape, std::string_view name)
{
    for (const Property& property : shape.properties)
        if (name == property.name)
            return &property;
    return nullptr;
}

void Checker::check_object(json& object, const Shape& shape, const Place& place) const
{
    if (!object.is_object())
        fail(place, "not an object");
    for (auto member = object.begin(); member != object.end();) {
        const Property* property = find(shape, member.key());
        if (property == nullptr) {
            member = object.erase(member);
            continue;
        }
        check_value(member.value(), *property, place);
        ++member;
    }
    for (const Property& property : shape.properties)
        if (property.need == Need::required && !object.contains(property.name))
            fail(place, text(property.name, " is missing"));
}

json::array_t& Checker::array(json& value, const Property& property, const Place& place) const
{
    if (!value.is_array())
        fail(place, text(property.name, " is not an array"));
    return value.get_ref<json::array_t&>();
}

void Checker::check_unsigned(json& value, double most, const Property& property, const Place& place) const
{
    // JSON knows no integers: 3.0 and 3e0 are 3. [JSON Schema, "integer"]
    const double number = value.is_number() ? value.get<double>() : -1.0;
    if (!(number >= 0.0 && number <= most) || number != std::floor(number))
        fail(place,
             text(property.name, " is not a whole number from 0 to ", static_cast<std::int64_t>(most)));
    value = static_cast<std::uint64_t>(number);
}

void Checker::check_number(json& value, const Property& property, const Place& place) const
{
    if (!value.is_number())
        fail(place, text(property.name, " is not a number"));
    const double number = value.get<double>();
    if (!(std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max())))
        fail(place, text(property.name, " is too large"));
    value = number;
}

void Checker::check_index_map(json& value, const Property& property, const Place& place) const
{
    if (!value.is_object())
        fail(place, text(property.name, " is not an object"));
    for (auto& [name, index] : value.items()) {
        const std::string shown = printable(name);
        check_unsigned(index, std::numeric_limits<std::int32_t>::max(), one(shown.c_str(), Kind::index),
                       place);
    }
}

void Checker::check_value(json& value, const Property& property, const Place& place) const
{
    constexpr double most_index = std::numeric_limits<std::int32_t>::max();
    constexpr double most_size = 9007199254740992.0;
    switch (property.kind) {
    case Kind::flag:
        if (!value.is_boolean())
            fail(place, text(property.name, " is not true or false"));
        return;
    case Kind::word:
        if (!value.is_string())
            fail(place, text(property.name, " is not a string"));
        return;
    case Kind::words:
        for (const json& word : array(value, property, place))
            if (!word.is_string())
                fail(place, text(property.name, " holds something that is not a string"));
        return;
    case Kind::number:
        return check_number(value, property, place);
    case Kind::numbers:
        for (json& number : array(value, property, place))
            check_number(number, property, place);
        if (property.length != 0 && value.size() != property.length)
            fail(place, text(property.name, " has ", value.size(), " numbers, not ", property.length));
        return;
    case Kind::index:
        return check_unsigned(value, most_index, property, place);
    case Kind::indices:
        for (json& index : array(value, property, place))
            check_unsigned(index, most_index, property, place);
        return;
    case Kind::index_map:
        return check_index_map(value, property, place);
    case Kind::index_maps:
        for (json& map : array(value, property, place))
            check_index_map(map, property, place);
        return;
    case Kind::size:
        return check_unsigned(value, most_size, property, place);
    case Kind::object:
        return check_object(value, *property.shape, {&place, property.name, -1});
    case Kind::objects:
        std::ptrdiff_t index = 0;
        if (array(value, property, place).size() > property.most)
            fail(place, text("more than ", property.most, " ", property.name));
        for (json& object : array(value, property, place))
            check_object(object, *property.shape, {&place, property.element, index++});
        return;
    }
}

} // namespace

std::optional<std::size_t> top_level_limit(std::string_view name)
{
    constexpr std::size_t most_words = 10'000;
    const Property* property = find(root, name);
    if (property == nullptr)
        return std::nullopt;
    return property->kind == Kind::objects ? property->most : most_words;
}

void check_schema(json& document, const std::string& file)
{
    Checker(file).check_object(document, root, {});
}

} // namespace lambent::scene
