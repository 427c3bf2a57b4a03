#include "kitchen/glb.h"

#include "image/codes/png.h"

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

namespace lambent {
namespace {

using nlohmann::json;

// Numbers of glTF. [3.6.2.2, 3.6.1.1 of the specification]
constexpr int of_floats = 5126, of_uints = 5125, of_vertices = 34962, of_indices = 34963;
constexpr std::uint32_t json_chunk = 0x4e4f534au, binary_chunk = 0x004e4942u;

// The document and its binary chunk under construction.
class Writer {
public:
    explicit Writer(const scene::Scene& scene) : scene_(scene)
    {
        document_["asset"] = {{"version", "2.0"}, {"generator", "lambent"}};
    }

    std::vector<std::uint8_t> write()
    {
        for (const image::CodeImage& image : scene_.images)
            add_image(image);
        for (const scene::Material& material : scene_.materials)
            add_material(material);
        for (const scene::Mesh& mesh : scene_.meshes)
            add_mesh(mesh);
        for (const scene::Instance& instance : scene_.instances)
            add_node(instance);
        document_["scene"] = 0;
        document_["buffers"] = {{{"byteLength", bytes_.size()}}};
        return container();
    }

private:
    std::size_t add_view(const void* data, std::size_t size, int target)
    {
        json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}};
        if (target != 0)
            view["target"] = target;
        const auto* const from = static_cast<const std::uint8_t*>(data);
        bytes_.insert(bytes_.end(), from, from + size);
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        document_["bufferViews"].push_back(view);
        return document_["bufferViews"].size() - 1;
    }

    template <class Vector>
    std::size_t add_accessor(const std::vector<Vector>& values, const char* type)
    {
        const bool floats = std::is_same_v<typename Vector::value_type, float>;
        const int scalars = floats ? 1 : Vector::length(); // of each value, which glTF counts
        json accessor = {{"bufferView", add_view(values.data(), values.size() * sizeof(Vector),
                                                 floats ? of_vertices : of_indices)},
                         {"componentType", floats ? of_floats : of_uints},
                         {"count", values.size() * static_cast<std::size_t>(scalars)},
                         {"type", type}};
        document_["accessors"].push_back(accessor);
        return document_["accessors"].size() - 1;
    }

    void add_image(const image::CodeImage& image)
    {
        const std::vector<std::uint8_t> png = image::encode_png(image);
        document_["images"].push_back(
            {{"bufferView", add_view(png.data(), png.size(), 0)}, {"mimeType", "image/png"}});
        document_["textures"].push_back({{"source", document_["images"].size() - 1}});
    }

    void add_material(const scene::Material& m)
    {
        json base = {{"metallicFactor", m.metallic},
                     {"roughnessFactor", m.perceptual_roughness},
                     {"baseColorFactor", {m.base_color.r, m.base_color.g, m.base_color.b, m.base_color.a}}};
        if (const scene::TextureUse& use = m.base_color_texture; use.image >= 0) {
            const glm::mat3& t = use.transform;
            base["baseColorTexture"] = {
                {"index", use.image},
                {"extensions",
                 {{"KHR_texture_transform",
                   {{"scale", {t[0][0], t[1][1]}}, {"offset", {t[2][0], t[2][1]}}}}}}};
            use_extension("KHR_texture_transform");
        }
        json material = {{"name", m.name}, {"pbrMetallicRoughness", base}, {"doubleSided", m.double_sided}};
        add_emission(m, material);
        document_["materials"].push_back(material);
    }

    void add_emission(const scene::Material& m, json& material)
    {
        const float most = std::max({m.emissive.r, m.emissive.g, m.emissive.b});
        if (!(most > 0.0f))
            return;
        const float strength = std::max(most, 1.0f);
        const glm::vec3 factor = m.emissive / strength;
        material["emissiveFactor"] = {factor.r, factor.g, factor.b};
        if (strength > 1.0f) {
            material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
            use_extension("KHR_materials_emissive_strength");
        }
    }

    void use_extension(const char* name)
    {
        json& used = document_["extensionsUsed"];
        if (std::find(used.begin(), used.end(), name) == used.end())
            used.push_back(name);
    }

    void add_mesh(const scene::Mesh& mesh)
    {
        json attributes = {{"POSITION", add_accessor(mesh.positions, "VEC3")}};
        glm::vec3 low(mesh.positions.at(0)), high(low);
        for (const glm::vec3& p : mesh.positions)
            low = glm::min(low, p), high = glm::max(high, p);
        document_["accessors"].back()["min"] = {low.x, low.y, low.z};
        document_["accessors"].back()["max"] = {high.x, high.y, high.z};
        if (!mesh.normals.empty())
            attributes["NORMAL"] = add_accessor(mesh.normals, "VEC3");
        if (!mesh.colors.empty())
            attributes["COLOR_0"] = add_accessor(mesh.colors, "VEC4");
        if (!mesh.texcoords[0].empty())
            attributes["TEXCOORD_0"] = add_accessor(mesh.texcoords[0], "VEC2");
        const std::size_t indices = add_accessor(mesh.triangles, "SCALAR");
        document_["meshes"].push_back(
            {{"primitives",
              {{{"attributes", attributes}, {"indices", indices}, {"material", mesh.material}}}}});
    }

    void add_node(const scene::Instance& instance)
    {
        json node = {{"mesh", instance.mesh}};
        if (instance.transform != glm::mat4(1.0f)) {
            const float* const numbers = glm::value_ptr(instance.transform);
            node["matrix"] = std::vector<float>(numbers, numbers + 16);
        }
        document_["nodes"].push_back(node);
        document_["scenes"][0]["nodes"].push_back(document_["nodes"].size() - 1);
    }

    std::vector<std::uint8_t> container() const
    {
        std::string text = document_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::vector<std::uint8_t> file;
        const auto add = [&](std::size_t number) {
            const auto word = static_cast<std::uint32_t>(number);
            const std::size_t at = file.size();
            file.resize(at + 4);
            std::memcpy(&file[at], &word, 4);
        };
        add(0x46546c67u), add(2), add(12 + 8 + text.size() + 8 + bytes_.size());
        add(text.size()), add(json_chunk);
        file.insert(file.end(), text.begin(), text.end());
        add(bytes_.size()), add(binary_chunk);
        file.insert(file.end(), bytes_.begin(), bytes_.end());
        return file;
    }

    const scene::Scene& scene_;
    json document_;
    std::vector<std::uint8_t> bytes_;
};

// Vertex colours above 1, which glTF does not have, become those of the material.
scene::Scene with_colors_in_range(scene::Scene scene)
{
    std::vector<float> most(scene.materials.size(), 1.0f);
    const auto factor_of = [&](const scene::Mesh& mesh) -> float& {
        return most[static_cast<std::size_t>(mesh.material)];
    };
    for (const scene::Mesh& mesh : scene.meshes)
        for (const glm::vec4& color : mesh.colors)
            factor_of(mesh) = std::max({factor_of(mesh), color.r, color.g, color.b});
    for (scene::Mesh& mesh : scene.meshes)
        for (glm::vec4& color : mesh.colors)
            color = glm::vec4(glm::vec3(color) / factor_of(mesh), color.a);
    for (std::size_t i = 0; i < most.size(); ++i) {
        glm::vec4& color = scene.materials[i].base_color;
        color = glm::vec4(glm::vec3(color) * most[i], color.a);
    }
    return scene;
}

} // namespace

std::vector<std::uint8_t> encode_glb(const scene::Scene& scene)
{
    const scene::Scene in_range = with_colors_in_range(scene);
    return Writer(in_range).write();
}

} // namespace lambent
