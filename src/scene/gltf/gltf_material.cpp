#include "scene/gltf/gltf_material.h"

#include "scene/gltf_document/gltf_losses.h"
#include "scene/index.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace lambent::scene {
namespace {

// The file's texture settings, read while images that are used get their numbers.
class MaterialReader {
public:
    MaterialReader(const Document& document, Losses& losses) : document_(document), losses_(losses) {}

    Material read(int index);
    const std::vector<int>& images() const { return images_; }

private:
    void read_metallic_roughness(const tinygltf::PbrMetallicRoughness& source, Material& material);
    void read_emission(const tinygltf::Material& source, Material& material);
    void read_alpha(const tinygltf::Material& source, Material& material);

    template <class Info>
    TextureUse read_texture(const Info& info, const char* slot);
    template <class Info>
    TextureUse find_texture(const Info& info, const char* slot);
    Sampler read_sampler(int index);
    int scene_image(int image);

    float clamped(double value, double low, double high, const char* property);
    template <class... Parts>
    void warn(const Parts&... parts)
    {
        losses_.add(text(document_.file, ": ", name_, ": ", parts...));
    }

    const Document& document_;
    Losses& losses_;
    std::string name_;                                            // "material 3"
    std::map<std::pair<int, std::string_view>, int> image_index_; // by where the bytes are
    std::vector<int> images_;
};

float MaterialReader::clamped(double value, double low, double high, const char* property)
{
    const double kept = std::clamp(value, low, high);
    if (kept != value)
        warn(property, " ", value, " is outside its range: ", kept, " is used");
    return static_cast<float>(kept);
}

// Images that name the same bytes become one.
int MaterialReader::scene_image(int image)
{
    const ImageSource& source = document_.images[at(image)];
    const auto [found, is_new] =
        image_index_.try_emplace({source.buffer_view, source.uri}, static_cast<int>(images_.size()));
    if (is_new)
        images_.push_back(image);
    return found->second;
}

Wrap read_wrap(const Document& document, int code, int sampler)
{
    switch (code) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
        return Wrap::repeat;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
        return Wrap::mirrored_repeat;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
        return Wrap::clamp_to_edge;
    default:
        document.fail("sampler ", sampler, ": wrap mode ", code, " is not one of glTF");
    }
}

void read_magnification(const Document& document, int code, int index, Sampler& sampler)
{
    switch (code) {
    case -1:
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
        break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
        sampler.magnify_nearest = true;
        break;
    default:
        document.fail("sampler ", index, ": magFilter ", code, " is not one of glTF");
    }
}

void read_minification(const Document& document, int code, int index, Sampler& sampler)
{
    switch (code) {
    case -1:
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR:
        break;
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
        sampler.minify_nearest = code != TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST;
        sampler.nearest_mipmap = code != TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR;
        break;
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
        sampler.minify_nearest = code == TINYGLTF_TEXTURE_FILTER_NEAREST;
        sampler.mipmapped = false;
        break;
    default:
        document.fail("sampler ", index, ": minFilter ", code, " is not one of glTF");
    }
}

Sampler MaterialReader::read_sampler(int index)
{
    Sampler sampler;
    if (index < 0)
        return sampler;
    if (at(index) >= document_.model.samplers.size()) {
        warn("sampler ", index, " does not exist: repeating and smooth");
        return sampler;
    }
    const tinygltf::Sampler& source = document_.model.samplers[at(index)];
    losses_.spare("it repeats", [&] { sampler.wrap_u = read_wrap(document_, source.wrapS, index); });
    losses_.spare("it repeats", [&] { sampler.wrap_v = read_wrap(document_, source.wrapT, index); });
    losses_.spare("it is smooth", [&] { read_magnification(document_, source.magFilter, index, sampler); });
    losses_.spare("it is smooth", [&] { read_minification(document_, source.minFilter, index, sampler); });
    return sampler;
}

std::array<double, 2> two_numbers(const tinygltf::Value& object, const char* name,
                                  std::array<double, 2> missing)
{
    if (!object.Has(name))
        return missing;
    const tinygltf::Value& array = object.Get(name);
    return {array.Get(0).GetNumberAsDouble(), array.Get(1).GetNumberAsDouble()};
}

// T * R * S, where R turns by -rotation as the formula is usually written: v counts downwards. The listing in
// the extension's text has the other sign; its example and the implementations agree on this one
// (KhronosGroup/glTF issue 1563). [KHR_texture_transform]
glm::mat3 transform_of(const tinygltf::Value& extension)
{
    const auto offset = two_numbers(extension, "offset", {0.0, 0.0});
    const auto scale = two_numbers(extension, "scale", {1.0, 1.0});
    const double angle = extension.Has("rotation") ? extension.Get("rotation").GetNumberAsDouble() : 0.0;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // Columns: what u becomes, what v becomes, where the origin goes.
    return {glm::vec3(c * scale[0], -s * scale[0], 0.0), glm::vec3(s * scale[1], c * scale[1], 0.0),
            glm::vec3(offset[0], offset[1], 1.0)};
}

template <class Info>
TextureUse MaterialReader::read_texture(const Info& info, const char* slot)
{
    TextureUse use;
    if (info.index >= 0)
        losses_.spare("the texture is left out", [&] { use = find_texture(info, slot); });
    return use;
}

template <class Info>
TextureUse MaterialReader::find_texture(const Info& info, const char* slot)
{
    TextureUse use;
    const auto& textures = document_.model.textures;
    if (at(info.index) >= textures.size())
        document_.fail(name_, ", ", slot, ": texture ", info.index, " does not exist");
    const tinygltf::Texture& texture = textures[at(info.index)];
    if (is_broken(texture.extensions))
        throw told_already();
    use.sampler = read_sampler(texture.sampler);
    use.texcoord = info.texCoord;
    const auto extension = info.extensions.find("KHR_texture_transform");
    if (extension != info.extensions.end()) {
        use.transform = transform_of(extension->second);
        if (extension->second.Has("texCoord"))
            use.texcoord = extension->second.Get("texCoord").GetNumberAsInt();
    }
    if (texture.source < 0) {
        warn(slot, ": texture ", info.index, " has no PNG or JPEG image: left out");
        return {};
    }
    if (at(texture.source) >= document_.images.size())
        document_.fail("texture ", info.index, ": image ", texture.source, " does not exist");
    use.image = scene_image(texture.source);
    return use;
}

void MaterialReader::read_metallic_roughness(const tinygltf::PbrMetallicRoughness& source, Material& material)
{
    for (int channel = 0; channel < 4; ++channel)
        material.base_color[channel] =
            clamped(source.baseColorFactor[at(channel)], 0.0, 1.0, "baseColorFactor");
    material.metallic = clamped(source.metallicFactor, 0.0, 1.0, "metallicFactor");
    material.perceptual_roughness = clamped(source.roughnessFactor, 0.0, 1.0, "roughnessFactor");
    material.base_color_texture = read_texture(source.baseColorTexture, "baseColorTexture");
    material.metallic_roughness_texture =
        read_texture(source.metallicRoughnessTexture, "metallicRoughnessTexture");
}

void MaterialReader::read_emission(const tinygltf::Material& source, Material& material)
{
    constexpr double most = 1e30; // leaves room for what is multiplied onto it
    double strength = 1.0;
    const auto extension = source.extensions.find("KHR_materials_emissive_strength");
    if (extension != source.extensions.end() && extension->second.Has("emissiveStrength"))
        strength = clamped(extension->second.Get("emissiveStrength").GetNumberAsDouble(), 0.0, most,
                           "emissiveStrength");
    for (int channel = 0; channel < 3; ++channel)
        material.emissive[channel] = static_cast<float>(
            strength * clamped(source.emissiveFactor[at(channel)], 0.0, 1.0, "emissiveFactor"));
    material.emissive_texture = read_texture(source.emissiveTexture, "emissiveTexture");
}

void MaterialReader::read_alpha(const tinygltf::Material& source, Material& material)
{
    if (source.alphaMode == "OPAQUE")
        material.alpha_mode = AlphaMode::opaque;
    else if (source.alphaMode == "MASK")
        material.alpha_mode = AlphaMode::mask;
    else if (source.alphaMode == "BLEND")
        material.alpha_mode = AlphaMode::blend;
    else
        warn("alphaMode \"", printable(source.alphaMode), "\" is not one of glTF: OPAQUE is used");
    material.alpha_cutoff = clamped(source.alphaCutoff, 0.0, 1e30, "alphaCutoff");
}

Material MaterialReader::read(int index)
{
    Material material;
    if (index < 0)
        return material;
    name_ = text("material ", index);
    const tinygltf::Material& source = document_.model.materials[at(index)];
    material.name = source.name;
    read_metallic_roughness(source.pbrMetallicRoughness, material);
    material.normal_texture = read_texture(source.normalTexture, "normalTexture");
    material.normal_scale = static_cast<float>(source.normalTexture.scale);
    material.occlusion_texture = read_texture(source.occlusionTexture, "occlusionTexture");
    material.occlusion_strength = clamped(source.occlusionTexture.strength, 0.0, 1.0, "occlusion strength");
    read_emission(source, material);
    read_alpha(source, material);
    material.double_sided = source.doubleSided;
    material.unlit = source.extensions.contains("KHR_materials_unlit");
    return material;
}

} // namespace

int MaterialTable::index_of(int material) const
{
    return material < 0 || at(material) + 1 >= scene_index.size() ? scene_index.back()
                                                                  : scene_index[at(material)];
}

int MaterialTable::line_index_of(int material, bool unlit)
{
    const int index = index_of(material);
    Material copy = materials[at(index)];
    if (copy.double_sided && (copy.unlit || !unlit))
        return index;
    const auto [found, is_new] = line_copies_.try_emplace({index, unlit}, static_cast<int>(materials.size()));
    if (is_new) {
        copy.double_sided = true;
        copy.unlit = copy.unlit || unlit;
        materials.push_back(std::move(copy));
    }
    return found->second;
}

MaterialTable read_materials(const Document& document, std::span<const int> used, Warnings& warnings)
{
    MaterialTable table;
    table.scene_index.assign(document.model.materials.size() + 1, -1);
    Losses losses(document.file, warnings);
    MaterialReader reader(document, losses);
    for (int material : used) {
        if (material >= 0 && at(material) >= document.model.materials.size()) {
            losses.add(text(document.file, ": material ", material, " does not exist"),
                       "the default is used");
            material = -1;
        }
        int& index = material < 0 ? table.scene_index.back() : table.scene_index[at(material)];
        if (index >= 0)
            continue;
        index = static_cast<int>(table.materials.size());
        table.materials.push_back(reader.read(material));
    }
    if (table.materials.empty())
        table.materials.emplace_back();
    table.images = reader.images();
    return table;
}

TextureNeeds texture_needs(const Material& material)
{
    TextureNeeds needs;
    for (const TextureUse* use :
         {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
          &material.occlusion_texture, &material.emissive_texture})
        if (use->image >= 0)
            needs.texcoords.insert(use->texcoord);
    if (material.normal_texture.image >= 0) {
        needs.normal_map_set = material.normal_texture.texcoord;
        needs.normal_map_transform = material.normal_texture.transform;
    }
    return needs;
}

} // namespace lambent::scene
