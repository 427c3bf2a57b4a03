#include "scene/gltf.h"

#include "base/file.h"
#include "scene/gltf_bytes.h"
#include "scene/gltf_document.h"
#include "scene/gltf_image.h"
#include "scene/gltf_light.h"
#include "scene/gltf_mesh.h"
#include "scene/gltf_nodes.h"

namespace lambent::scene {

Scene load_gltf_bytes(const GltfSource& source, Warnings& warnings)
{
    const Document document = open_document(source, warnings);
    const NodeTree nodes = build_node_tree(document, warnings);
    DrawnMeshes drawn = read_meshes(document, nodes, warnings);

    Scene scene;
    scene.meshes = std::move(drawn.meshes);
    scene.instances = std::move(drawn.instances);
    scene.materials = std::move(drawn.materials.materials);
    scene.images = read_images(document, drawn.materials.images);
    scene.cameras = read_cameras(document, nodes, warnings);
    scene.lights = read_lights(document, nodes, warnings);
    if (scene.instances.empty())
        warnings.push_back(text(document.file, ": nothing to draw"));
    return scene;
}

Scene load_gltf(const std::filesystem::path& path, Warnings& warnings)
{
    const std::vector<std::uint8_t> bytes = read_file(path);
    return load_gltf_bytes({path.string(), bytes, path.parent_path()}, warnings);
}

} // namespace lambent::scene
