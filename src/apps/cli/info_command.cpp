#include "apps/cli/commands.h"
#include "apps/common/console.h"
#include "apps/common/stats.h"
#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "image/files/image_io.h"
#include "scene/gltf/gltf.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace lambent::cli {
namespace {

using Json = nlohmann::ordered_json;

// A point of the scene in world coordinates.
Json triple(const glm::vec3& v, const glm::dvec3& origin)
{
    if (origin == glm::dvec3(0.0))
        return {v.x, v.y, v.z};
    const glm::dvec3 place = origin + glm::dvec3(v);
    return {place.x, place.y, place.z};
}

Json describe_scene(const scene::Scene& scene)
{
    Json info = {{"format", "glTF 2.0"}, {"triangles", scene::triangle_count(scene)}};
    const scene::LineCount thin = scene::line_count(scene);
    info["lines"] = thin.lines;
    info["points"] = thin.points;
    info["instances"] = scene.instances.size();
    info["meshes"] = std::count_if(scene.meshes.begin(), scene.meshes.end(),
                                   [](const scene::Mesh& mesh) { return !scene::is_empty(mesh); });
    info["materials"] = scene.materials.size();
    info["textures"] = Json::array();
    for (const image::CodeImage& image : scene.images)
        info["textures"].push_back(text(image.width, "x", image.height, ", ", image.bits, " bits"));
    info["cameras"] = Json::array();
    for (const scene::Camera& camera : scene.cameras)
        info["cameras"].push_back(camera.name);
    info["lights"] = scene.lights.size();
    info["animations"] = Json::array();
    for (const scene::AnimationInfo& animation : scene.animations)
        info["animations"].push_back({{"name", animation.name}, {"seconds", animation.seconds}});
    const scene::Bounds bounds = scene::bounds(scene);
    if (bounds.low.x <= bounds.high.x) {
        info["low_corner_m"] = triple(bounds.low, scene.origin);
        info["high_corner_m"] = triple(bounds.high, scene.origin);
    }
    return info;
}

// Whether the file starts like a binary glTF or like JSON.
bool looks_like_gltf(const std::string& path)
{
    const std::vector<std::uint8_t> start = read_start(path, 64);
    const std::string head(start.begin(), start.end());
    return head.starts_with("glTF") || head.find_first_not_of(" \t\r\n\xef\xbb\xbf") == head.find('{');
}

Json describe(const std::string& path, Warnings& warnings)
{
    if (looks_like_gltf(path))
        return describe_scene(scene::load_gltf(path, warnings, {true, {}}));
    const image::ImageInfo info = image::inspect(path, &warnings);
    return {{"format", info.format}, {"detail", info.detail}, {"width", info.width}, {"height", info.height}};
}

std::string plain(const Json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_object())
        return text(plain(value["name"]), ", ", value["seconds"].get<double>(), " s");
    if (!value.is_array())
        return value.dump();
    std::string line;
    for (const Json& item : value)
        line += text(line.empty() ? "" : "; ", plain(item));
    return line.empty() ? "none" : line;
}

} // namespace

void run(const InfoArguments& arguments)
{
    Warnings warnings;
    Json info = describe(arguments.file, warnings);
    Console(arguments.common.verbosity).warn_of_input(warnings, arguments.common);
    if (arguments.json || arguments.common.stats_json) {
        info["file"] = arguments.file;
        print(info);
        return;
    }
    for (const auto& [key, value] : info.items())
        std::printf("%-14s %s\n", key.c_str(), plain(value).c_str());
}

} // namespace lambent::cli
