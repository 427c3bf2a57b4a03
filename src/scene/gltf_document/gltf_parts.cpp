#include "scene/gltf_document/gltf_parts.h"

#include "scene/gltf_document/gltf_json.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <utility>

namespace lambent::scene {
namespace {

using nlohmann::json;

bool is_marked_broken(const json& element)
{
    const auto extensions = element.find("extensions");
    return extensions != element.end() && extensions->contains(broken_mark);
}

std::map<std::string, int> take_index_map(const json& map)
{
    std::map<std::string, int> indices;
    for (const auto& [name, index] : map.items())
        indices.emplace(name, index.get<int>());
    return indices;
}

tinygltf::Primitive primitive_of(const json& source)
{
    tinygltf::Primitive primitive;
    primitive.attributes = take_index_map(source.at("attributes"));
    primitive.material = source.value("material", -1);
    primitive.indices = source.value("indices", -1);
    primitive.mode = source.value("mode", TINYGLTF_MODE_TRIANGLES);
    if (const auto targets = source.find("targets"); targets != source.end())
        for (const json& target : *targets)
            primitive.targets.push_back(take_index_map(target));
    // What they hold is not read, only which there are.
    if (const auto extensions = source.find("extensions"); extensions != source.end())
        for (const auto& [name, extension] : extensions->items())
            primitive.extensions.emplace(name, tinygltf::Value());
    return primitive;
}

} // namespace

json take(json& document, const char* name)
{
    const auto found = document.find(name);
    if (found == document.end())
        return json::array();
    json taken = std::move(*found);
    document.erase(found);
    return taken;
}

std::vector<ImageSource> take_images(json& document)
{
    std::vector<ImageSource> images;
    for (json& image : take(document, "images")) {
        ImageSource source;
        source.is_broken = is_marked_broken(image);
        if (image.contains("uri"))
            source.uri = std::move(image.at("uri").get_ref<std::string&>());
        source.buffer_view = image.value("bufferView", -1);
        if (image.contains("name"))
            source.name = std::move(image.at("name").get_ref<std::string&>());
        images.push_back(std::move(source));
    }
    return images;
}

// tinygltf refuses a channel without a node, and spends a kilobyte on each.
std::vector<AnimationSource> take_animations(json& document)
{
    std::vector<AnimationSource> animations;
    for (json& animation : take(document, "animations")) {
        AnimationSource source;
        source.name = animation.value("name", "");
        for (const json& channel : take(animation, "channels")) {
            if (is_marked_broken(channel))
                continue;
            const json& target = channel.at("target");
            source.channels.push_back({channel.at("sampler").get<int>(), target.value("node", -1),
                                       target.at("path").get<std::string>()});
        }
        for (const json& sampler : take(animation, "samplers"))
            source.samplers.push_back({sampler.value("input", unreadable_index),
                                       sampler.value("output", unreadable_index),
                                       sampler.value("interpolation", "LINEAR"), is_marked_broken(sampler)});
        animations.push_back(std::move(source));
    }
    return animations;
}

std::vector<tinygltf::Mesh> take_meshes(json& document)
{
    std::vector<tinygltf::Mesh> meshes;
    for (json& mesh : take(document, "meshes")) {
        tinygltf::Mesh& taken = meshes.emplace_back();
        taken.weights = mesh.value("weights", std::vector<double>());
        for (const json& primitive : take(mesh, "primitives"))
            taken.primitives.push_back(primitive_of(primitive));
    }
    return meshes;
}

std::vector<std::size_t> take_strides(json& document)
{
    std::vector<std::size_t> strides;
    if (const auto views = document.find("bufferViews"); views != document.end())
        for (json& view : *views) {
            strides.push_back(view.value("byteStride", std::size_t{0}));
            view.erase("byteStride");
        }
    return strides;
}

} // namespace lambent::scene
