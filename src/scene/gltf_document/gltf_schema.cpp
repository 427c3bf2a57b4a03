#include "scene/gltf_document/gltf_schema.h"

#include "scene/gltf_document/gltf_message.h"
#include "scene/gltf_document/gltf_model.h"

#include <algorithm>

namespace lambent::scene {
namespace {

using namespace gltf;

constexpr Need required = Need::required;

constexpr Property asset_properties[] = {value<&Asset::version>("version", required),
                                         value<&Asset::min_version>("minVersion")};
constexpr Shape asset{asset_properties};

constexpr Property scene_properties[] = {unread("name", Kind::word), value<&gltf::Scene::nodes>("nodes")};
constexpr Shape scene{scene_properties};

constexpr Property node_light_properties[] = {value<&Node::light>("light", required)};
constexpr Shape node_light{node_light_properties};
constexpr Property instancing_properties[] = {value<&Node::instances>("attributes")};
constexpr Shape instancing{instancing_properties};
constexpr Property visibility_properties[] = {value<&Node::visible>("visible")};
constexpr Shape visibility{visibility_properties};
constexpr Property node_extension_properties[] = {inside("KHR_lights_punctual", node_light),
                                                  inside("EXT_mesh_gpu_instancing", instancing),
                                                  inside("KHR_node_visibility", visibility)};
constexpr Shape node_extensions{node_extension_properties};
constexpr Property node_properties[] = {value<&Node::name>("name"),
                                        value<&Node::children>("children"),
                                        value<&Node::camera>("camera"),
                                        value<&Node::mesh>("mesh"),
                                        value<&Node::skin>("skin"),
                                        value<&Node::matrix>("matrix", Need::optional, 16),
                                        value<&Node::rotation>("rotation"),
                                        value<&Node::scale>("scale"),
                                        value<&Node::translation>("translation"),
                                        value<&Node::weights>("weights"),
                                        inside("extensions", node_extensions)};
constexpr Shape node{node_properties};

constexpr Property primitive_extension_properties[] = {
    presence<&Primitive::has_draco>("KHR_draco_mesh_compression")};
constexpr Shape primitive_extensions{primitive_extension_properties};
constexpr Property primitive_properties[] = {value<&Primitive::attributes>("attributes", required),
                                             value<&Primitive::indices>("indices"),
                                             value<&Primitive::material>("material"),
                                             value<&Primitive::mode>("mode"),
                                             value<&Primitive::targets>("targets"),
                                             inside("extensions", primitive_extensions)};
constexpr Shape primitive{primitive_properties};
constexpr Property mesh_properties[] = {unread("name", Kind::word), value<&gltf::Mesh::weights>("weights"),
                                        list<&gltf::Mesh::primitives>("primitives", primitive, "primitive")};
constexpr Shape mesh{mesh_properties};

constexpr Property sparse_indices_properties[] = {
    value<&SparseIndices::buffer_view>("bufferView", required),
    value<&SparseIndices::byte_offset>("byteOffset"),
    value<&SparseIndices::component_type>("componentType", required)};
constexpr Shape sparse_indices_shape{sparse_indices_properties};
constexpr Property sparse_values_properties[] = {value<&SparseValues::buffer_view>("bufferView", required),
                                                 value<&SparseValues::byte_offset>("byteOffset")};
constexpr Shape sparse_values_shape{sparse_values_properties};
constexpr Property sparse_properties[] = {value<&Sparse::count>("count", required),
                                          nested<&Sparse::indices>("indices", sparse_indices_shape, required),
                                          nested<&Sparse::values>("values", sparse_values_shape, required)};
constexpr Shape sparse{sparse_properties};
constexpr Property accessor_properties[] = {value<&Accessor::buffer_view>("bufferView"),
                                            value<&Accessor::byte_offset>("byteOffset"),
                                            value<&Accessor::component_type>("componentType", required),
                                            value<&Accessor::normalized>("normalized"),
                                            value<&Accessor::count>("count", required),
                                            value<&Accessor::type>("type", required),
                                            nested<&Accessor::sparse>("sparse", sparse)};

std::string accessor_misfit(const void* object)
{
    constexpr std::array<std::string_view, 7> types = {"SCALAR", "VEC2", "VEC3", "VEC4",
                                                       "MAT2",   "MAT3", "MAT4"};
    constexpr std::array components = {Component::i8,  Component::u8,  Component::i16,
                                       Component::u16, Component::u32, Component::f32};
    const auto& accessor = *static_cast<const Accessor*>(object);
    if (std::find(types.begin(), types.end(), accessor.type) == types.end())
        return text("type \"", printable(accessor.type), "\" is not defined by glTF");
    if (std::find(components.begin(), components.end(), accessor.component_type) == components.end())
        return text("componentType ", accessor.component_type, " is not defined by glTF");
    return {};
}

constexpr Shape accessor{accessor_properties, accessor_misfit};

constexpr Property buffer_view_properties[] = {
    value<&BufferView::buffer>("buffer", required), value<&BufferView::byte_offset>("byteOffset"),
    value<&BufferView::byte_length>("byteLength", required), value<&BufferView::byte_stride>("byteStride")};
constexpr Shape buffer_view{buffer_view_properties};
constexpr Property buffer_properties[] = {value<&Buffer::byte_length>("byteLength", required),
                                          value<&Buffer::uri>("uri")};
constexpr Shape buffer{buffer_properties};

constexpr Property image_properties[] = {value<&gltf::Image::uri>("uri"), unread("mimeType", Kind::word),
                                         value<&gltf::Image::buffer_view>("bufferView"),
                                         value<&gltf::Image::name>("name")};
constexpr Shape image{image_properties};
constexpr Property texture_properties[] = {value<&Texture::sampler>("sampler"),
                                           value<&Texture::source>("source")};
constexpr Shape texture{texture_properties};
constexpr Property sampler_properties[] = {
    value<&gltf::Sampler::mag_filter>("magFilter"), value<&gltf::Sampler::min_filter>("minFilter"),
    value<&gltf::Sampler::wrap_s>("wrapS"), value<&gltf::Sampler::wrap_t>("wrapT")};
constexpr Shape sampler{sampler_properties};

constexpr Property skin_properties[] = {value<&Skin::inverse_bind_matrices>("inverseBindMatrices"),
                                        unread("skeleton", Kind::index),
                                        value<&Skin::joints>("joints", required)};
constexpr Shape skin{skin_properties};

constexpr Property target_properties[] = {value<&AnimationTarget::node>("node"),
                                          value<&AnimationTarget::path>("path", required)};
constexpr Shape target{target_properties};
constexpr Property channel_properties[] = {value<&AnimationChannel::sampler>("sampler", required),
                                           nested<&AnimationChannel::target>("target", target, required)};
constexpr Shape channel{channel_properties};
constexpr Property keys_properties[] = {value<&AnimationSampler::input>("input", required),
                                        value<&AnimationSampler::interpolation>("interpolation"),
                                        value<&AnimationSampler::output>("output", required)};
constexpr Shape keys{keys_properties};
constexpr Property animation_properties[] = {value<&gltf::Animation::name>("name"),
                                             list<&gltf::Animation::channels>("channels", channel, "channel"),
                                             list<&gltf::Animation::samplers>("samplers", keys, "sampler")};
constexpr Shape animation{animation_properties};

constexpr Property perspective_properties[] = {
    value<&Perspective::aspect_ratio>("aspectRatio"), value<&Perspective::yfov>("yfov", required),
    value<&Perspective::zfar>("zfar"), value<&Perspective::znear>("znear", required)};
constexpr Shape perspective{perspective_properties};
constexpr Property orthographic_properties[] = {
    value<&Orthographic::xmag>("xmag", required), value<&Orthographic::ymag>("ymag", required),
    value<&Orthographic::zfar>("zfar", required), value<&Orthographic::znear>("znear", required)};
constexpr Shape orthographic{orthographic_properties};
constexpr Property camera_properties[] = {value<&gltf::Camera::name>("name"),
                                          value<&gltf::Camera::type>("type", required),
                                          nested<&gltf::Camera::perspective>("perspective", perspective),
                                          nested<&gltf::Camera::orthographic>("orthographic", orthographic)};

std::string camera_misfit(const void* object)
{
    const auto& camera = *static_cast<const gltf::Camera*>(object);
    if (camera.type != "perspective" && camera.type != "orthographic")
        return text("type \"", printable(camera.type), "\" is not defined by glTF");
    const bool is_there = camera.type == "perspective" ? !!camera.perspective : !!camera.orthographic;
    return is_there ? "" : text(camera.type, " is missing");
}

constexpr Shape camera{camera_properties, camera_misfit};

constexpr Property spot_properties[] = {value<&Spot::inner_cone_angle>("innerConeAngle"),
                                        value<&Spot::outer_cone_angle>("outerConeAngle")};
constexpr Shape spot{spot_properties};
constexpr Property light_properties[] = {
    unread("name", Kind::word),          value<&gltf::Light::type>("type", required),
    value<&gltf::Light::color>("color"), value<&gltf::Light::intensity>("intensity"),
    value<&gltf::Light::range>("range"), nested<&gltf::Light::spot>("spot", spot)};
constexpr Shape light{light_properties};
constexpr Property lights_properties[] = {list<&Model::lights>("lights", light, "light")};
constexpr Shape lights{lights_properties};
constexpr Property extension_properties[] = {inside("KHR_lights_punctual", lights)};
constexpr Shape extensions{extension_properties};

} // namespace

const Shape& document_shape()
{
    static const Property properties[] = {
        nested<&Model::asset>("asset", asset, required),
        value<&Model::scene>("scene"),
        list<&Model::scenes>("scenes", scene, "scene"),
        list<&Model::nodes>("nodes", node, "node"),
        list<&Model::meshes>("meshes", mesh, "mesh"),
        list<&Model::accessors>("accessors", accessor, "accessor"),
        list<&Model::buffer_views>("bufferViews", buffer_view, "bufferView"),
        list<&Model::buffers>("buffers", buffer, "buffer"),
        list<&Model::images>("images", image, "image"),
        list<&Model::textures>("textures", texture, "texture"),
        list<&Model::samplers>("samplers", sampler, "sampler"),
        list<&Model::materials>("materials", material_shape(), "material"),
        list<&Model::skins>("skins", skin, "skin"),
        list<&Model::cameras>("cameras", camera, "camera"),
        list<&Model::animations>("animations", animation, "animation"),
        inside("extensions", extensions),
        value<&Model::extensions_used>("extensionsUsed"),
        value<&Model::extensions_required>("extensionsRequired")};
    static const Shape shape{properties};
    return shape;
}

} // namespace lambent::scene
