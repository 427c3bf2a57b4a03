#include "bench/whole/glb_writer.h"

#include "base/file.h"

#include <nlohmann/json.hpp>

#include <cstring>

namespace lambent::bench {
namespace {

using Json = nlohmann::json;

// What is said in the JSON, and the bytes it points into.
struct Writer {
    Json json;
    std::vector<std::uint8_t> bytes;

    template <class T>
    int view(const std::vector<T>& values)
    {
        const std::size_t offset = bytes.size(), length = values.size() * sizeof(T);
        bytes.resize((offset + length + 3) / 4 * 4);
        std::memcpy(bytes.data() + offset, values.data(), length);
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}});
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }

    int accessor(Json accessor)
    {
        json["accessors"].push_back(std::move(accessor));
        return static_cast<int>(json["accessors"].size()) - 1;
    }

    int vectors(const std::vector<glm::vec3>& values)
    {
        scene::Bounds box;
        for (const glm::vec3& v : values)
            for (int k = 0; k < 3; ++k) {
                box.low[k] = std::min(box.low[k], v[k]);
                box.high[k] = std::max(box.high[k], v[k]);
            }
        return accessor({{"bufferView", view(values)},
                         {"componentType", 5126},
                         {"count", values.size()},
                         {"type", "VEC3"},
                         {"min", {box.low.x, box.low.y, box.low.z}},
                         {"max", {box.high.x, box.high.y, box.high.z}}});
    }
};

Json material(const scene::Material& m)
{
    return {{"pbrMetallicRoughness",
             {{"baseColorFactor", {m.base_color.r, m.base_color.g, m.base_color.b, m.base_color.a}},
              {"metallicFactor", m.metallic},
              {"roughnessFactor", m.perceptual_roughness}}}};
}

void append(std::vector<std::uint8_t>& out, std::uint32_t number)
{
    for (int i = 0; i < 4; ++i)
        out.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

} // namespace

void write_glb(const scene::Scene& scene, const std::string& path)
{
    Writer w;
    w.json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
    std::vector<Json> shapes;
    for (const scene::Mesh& mesh : scene.meshes) {
        const int positions = w.vectors(mesh.positions), normals = w.vectors(mesh.normals);
        const int indices = w.accessor({{"bufferView", w.view(mesh.triangles)},
                                        {"componentType", 5125},
                                        {"count", 3 * mesh.triangles.size()},
                                        {"type", "SCALAR"}});
        shapes.push_back(
            {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", indices}});
    }
    for (const scene::Material& m : scene.materials)
        w.json["materials"].push_back(material(m));
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        Json shape = shapes[static_cast<std::size_t>(instance.mesh)];
        shape["material"] = instance.material;
        w.json["meshes"].push_back({{"primitives", {shape}}});
        std::vector<float> matrix(&instance.transform[0][0], &instance.transform[0][0] + 16);
        w.json["nodes"].push_back({{"mesh", i}, {"matrix", matrix}});
        w.json["scenes"][0]["nodes"].push_back(i);
    }
    w.json["buffers"].push_back({{"byteLength", w.bytes.size()}});

    std::string json = w.json.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::vector<std::uint8_t> file = {'g', 'l', 'T', 'F'};
    append(file, 2);
    append(file, static_cast<std::uint32_t>(28 + json.size() + w.bytes.size()));
    append(file, static_cast<std::uint32_t>(json.size()));
    file.insert(file.end(), {'J', 'S', 'O', 'N'});
    file.insert(file.end(), json.begin(), json.end());
    append(file, static_cast<std::uint32_t>(w.bytes.size()));
    file.insert(file.end(), {'B', 'I', 'N', 0});
    file.insert(file.end(), w.bytes.begin(), w.bytes.end());
    write_file(path, file);
}

} // namespace lambent::bench
