#include "scene/gltf/gltf_material.h"

#include "scene/gltf/gltf_sampler.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf_document/gltf_material_path.h"
#include "scene/index.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace lambent::scene {
namespace {

// A number of a material: its path in the material's JSON, its default and its range.
struct Factor {
    std::string_view path;
    double missing;
    double low, high;
    std::string_view name = {}; ///< in messages; empty: the path's last word
};

constexpr double huge = 1e30; // products with other factors stay within floats
constexpr double any = std::numeric_limits<float>::max();
constexpr Factor emissive_strength{"extensions/KHR_materials_emissive_strength/emissiveStrength", 1.0, 0.0,
                                   huge};
constexpr Factor alpha_cutoff{"alphaCutoff", 0.5, 0.0, huge};

std::string_view last_word(std::string_view path)
{
    return path.substr(path.rfind('/') + 1); // npos + 1 is 0
}

// The number that the file has at a path, if any.
std::optional<double> number_at(const gltf::Material& source, std::string_view path, std::size_t component)
{
    if (const auto found = source.factors.find(path); found != source.factors.end())
        return found->second[component];
    // A texture's scale or strength.
    const std::string_view name = last_word(path);
    const auto texture = source.textures.find(path.substr(0, path.size() - name.size() - 1));
    if (path == name || texture == source.textures.end())
        return std::nullopt;
    return name == "scale" ? texture->second.scale : texture->second.strength;
}

// Reads materials, and numbers the images that they use.
class MaterialReader {
public:
    MaterialReader(const Document& document, Losses& losses) : document_(document), losses_(losses) {}

    Material read(int index);
    const std::vector<int>& images() const { return images_; }

private:
    void read_parameters(const gltf::Material& source, Material& material);
    void read_textures(const gltf::Material& source, Material& material);
    void read_alpha(const gltf::Material& source, Material& material);

    float read_factor(const gltf::Material& source, const Factor& factor, std::size_t component = 0);
    void read_numbers(const gltf::Material& source, const Factor& factor, std::span<float> to);
    TextureUse read_texture(const gltf::Material& source, std::string_view path);
    TextureUse find_texture(const gltf::TextureInfo& info, std::string_view slot);
    Sampler read_sampler(int index);
    int scene_image(int image);

    template <class... Parts>
    void warn(const Parts&... parts)
    {
        losses_.add(text(document_.file, ": ", name_, ": ", parts...));
    }

    const Document& document_;
    Losses& losses_;
    std::string name_;                                            // "material 3"
    std::map<std::pair<int, std::string_view>, int> image_index_; // by bufferView and uri
    std::vector<int> images_;
};

float MaterialReader::read_factor(const gltf::Material& source, const Factor& factor, std::size_t component)
{
    const double value = number_at(source, factor.path, component).value_or(factor.missing);
    const double kept = std::clamp(value, factor.low, factor.high);
    if (kept != value)
        warn(factor.name.empty() ? last_word(factor.path) : factor.name, " ", value,
             " is outside its range: ", kept, " is used");
    return static_cast<float>(kept);
}

// Images with the same source become one.
int MaterialReader::scene_image(int image)
{
    const gltf::Image& source = document_.model.images[at(image)];
    const auto [found, is_new] =
        image_index_.try_emplace({source.buffer_view, source.uri}, static_cast<int>(images_.size()));
    if (is_new)
        images_.push_back(image);
    return found->second;
}

Sampler MaterialReader::read_sampler(int index)
{
    if (index < 0)
        return {};
    if (at(index) < document_.model.samplers.size())
        return scene::read_sampler(document_, index, losses_);
    warn("sampler ", index, " does not exist: the default sampler is used");
    return {};
}

// T * R * S, where R rotates by -rotation in the usual notation, since v points down. The listing in the extension's
// text has the other sign; its example and the implementations agree on this one (KhronosGroup/glTF issue 1563).
// [KHR_texture_transform]
glm::mat3 transform_of(const gltf::TextureTransform& transform)
{
    const auto& [offset, scale, angle, tex_coord] = transform;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // Columns: the images of the u axis, the v axis and the origin.
    return {glm::vec3(c * scale[0], -s * scale[0], 0.0), glm::vec3(s * scale[1], c * scale[1], 0.0),
            glm::vec3(offset[0], offset[1], 1.0)};
}

TextureUse MaterialReader::read_texture(const gltf::Material& source, std::string_view path)
{
    TextureUse use;
    if (const auto found = source.textures.find(path); found != source.textures.end())
        losses_.spare("the texture is left out", [&] { use = find_texture(found->second, last_word(path)); });
    return use;
}

TextureUse MaterialReader::find_texture(const gltf::TextureInfo& info, std::string_view slot)
{
    TextureUse use;
    const auto& textures = document_.model.textures;
    if (at(info.index) >= textures.size())
        document_.fail(name_, ", ", slot, ": texture ", info.index, " does not exist");
    const gltf::Texture& texture = textures[at(info.index)];
    if (texture.is_broken)
        throw told_already();
    use.sampler = read_sampler(texture.sampler);
    use.texcoord = info.tex_coord;
    if (info.transform) {
        use.transform = transform_of(*info.transform);
        use.texcoord = info.transform->tex_coord.value_or(info.tex_coord);
    }
    if (texture.source < 0) {
        warn(slot, ": texture ", info.index, " has no PNG or JPEG image: left out");
        return {};
    }
    if (at(texture.source) >= document_.model.images.size())
        document_.fail("texture ", info.index, ": image ", texture.source, " does not exist");
    use.image = scene_image(texture.source);
    return use;
}

// Reads the rows of shading/material/parameters.h, whose factors all range from 0 to 1.
void MaterialReader::read_parameters(const gltf::Material& source, Material& material)
{
#define READ(target, object, key, value, words)                                                              \
    {                                                                                                        \
        static constexpr MaterialPath path(#object, #key);                                                   \
        read_numbers(source, {path.view(), value, 0.0, 1.0, words}, target);                                 \
    }
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture)                                    \
    READ((std::span<float, 4>(&material.name.x, 4)), object, key, value, "")
#define COLOR(name, number, value, object, key, texture)                                                     \
    READ((std::span<float, 3>(&material.name.x, 3)), object, key, value, "")
#define SCALAR(name, number, value, object, key, texture, channel)                                           \
    READ((std::span<float, 1>(&material.name, 1)), object, key, value, "")
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel)                                \
    READ((std::span<float, 1>(&material.factor, 1)), object, key, value, "")
#define STRENGTH(name, factor, number, value, object, key, texture, channel)                                 \
    READ((std::span<float, 1>(&material.factor, 1)), object, key, value, #name " strength")
#include "shading/material/parameters.h"
#undef READ
    const double strength = read_factor(source, emissive_strength);
    for (int channel = 0; channel < 3; ++channel)
        material.emissive[channel] =
            static_cast<float>(strength * static_cast<double>(material.emissive[channel]));
}

void MaterialReader::read_numbers(const gltf::Material& source, const Factor& factor, std::span<float> to)
{
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = read_factor(source, factor, i);
}

// Reads the rows of shading/material/textures.h.
void MaterialReader::read_textures(const gltf::Material& source, Material& material)
{
#define TEXTURE(name, number, transfer, object, key)                                                         \
    {                                                                                                        \
        static constexpr MaterialPath path(#object, #key);                                                   \
        material.name##_texture = read_texture(source, path.view());                                         \
    }
#define NORMAL_TEXTURE(name, number, object, key)                                                            \
    TEXTURE(name, number, linear, object, key)                                                               \
    {                                                                                                        \
        static constexpr MaterialPath path(#object, #key "/scale");                                          \
        material.name##_scale = read_factor(source, {path.view(), 1.0, -any, any});                          \
    }
#include "shading/material/textures.h"
}

void MaterialReader::read_alpha(const gltf::Material& source, Material& material)
{
    if (source.alpha_mode == "OPAQUE")
        material.alpha_mode = AlphaMode::opaque;
    else if (source.alpha_mode == "MASK")
        material.alpha_mode = AlphaMode::mask;
    else if (source.alpha_mode == "BLEND")
        material.alpha_mode = AlphaMode::blend;
    else
        warn("alphaMode \"", printable(source.alpha_mode), "\" is not defined by glTF: OPAQUE is used");
    material.alpha_cutoff = read_factor(source, alpha_cutoff);
}

Material MaterialReader::read(int index)
{
    Material material;
    if (index < 0)
        return material;
    name_ = text("material ", index);
    const gltf::Material& source = document_.model.materials[at(index)];
    material.name = source.name;
    read_parameters(source, material);
    read_textures(source, material);
    read_alpha(source, material);
    material.double_sided = source.double_sided;
    material.unlit = source.unlit;
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
    for_each_texture(material, [&](int, const TextureUse& use, TextureCodes) {
        if (use.image >= 0)
            needs.texcoords.insert(use.texcoord);
    });
    // A mesh has one set of tangents, which follow the first of several normal maps.
    const auto need_tangents = [&](const TextureUse& use) {
        if (use.image < 0 || needs.normal_map_set >= 0)
            return;
        needs.normal_map_set = use.texcoord;
        needs.normal_map_transform = use.transform;
    };
#define TEXTURE(name, number, transfer, object, key)
#define NORMAL_TEXTURE(name, number, object, key) need_tangents(material.name##_texture);
#include "shading/material/textures.h"
    return needs;
}

} // namespace lambent::scene
