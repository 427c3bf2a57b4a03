#include "scene/gltf/gltf_material.h"

#include "scene/gltf/gltf_texture.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf_document/gltf_material_path.h"
#include "scene/index.h"

#include <algorithm>
#include <limits>
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
    std::string_view name = {}; // in messages; empty: the path's last word
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

// Reads materials and their textures.
class MaterialReader {
public:
    MaterialReader(const Document& document, Losses& losses)
        : document_(document), losses_(losses), textures_(document, losses)
    {
    }

    Material read(int index);
    const std::vector<int>& images() const { return textures_.images(); }

private:
    void read_parameters(const gltf::Material& source, Material& material);
    void read_textures(const gltf::Material& source, Material& material);
    void read_alpha(const gltf::Material& source, Material& material);

    float read_factor(const gltf::Material& source, const Factor& factor, std::size_t component = 0);
    void read_numbers(const gltf::Material& source, const Factor& factor, std::span<float> to);
    TextureUse read_texture(const gltf::Material& source, std::string_view path);

    template <class... Parts>
    void warn(const Parts&... parts)
    {
        losses_.add(text(document_.file, ": ", name_, ": ", parts...));
    }

    const Document& document_;
    Losses& losses_;
    TextureReader textures_;
    std::string name_; // "material 3"
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

TextureUse MaterialReader::read_texture(const gltf::Material& source, std::string_view path)
{
    const auto found = source.textures.find(path);
    return found == source.textures.end() ? TextureUse()
                                          : textures_.read(found->second, name_, last_word(path));
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
