#include "view/widened_scene.h"

#include "view/thin_shapes.h"

namespace lambent::view {
namespace {

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

scene::Mesh emptied(const scene::Mesh& mesh)
{
    scene::Mesh empty;
    empty.material = mesh.material;
    return empty;
}

} // namespace

WidenedScene::WidenedScene(const scene::Scene& scene, Others others) : source_(scene)
{
    for (const scene::Mesh& mesh : scene.meshes)
        widened_.meshes.push_back(has_lines(mesh) || others == Others::left_out ? emptied(mesh) : mesh);
    widened_.instances = scene.instances;
    widened_.materials = scene.materials;
    widened_.cameras = scene.cameras;
    widened_.lights = scene.lights;
    widened_.animations = scene.animations;
    widened_.rest_bounds = scene.rest_bounds;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Mesh& mesh = scene.meshes[at(scene.instances[i].mesh)];
        if (!has_lines(mesh))
            continue;
        instances_.push_back(i);
        widened_.instances[i].mesh = static_cast<int>(widened_.meshes.size());
        widened_.instances[i].transform = glm::mat4(1.0f);
        widened_.meshes.push_back(emptied(mesh));
    }
}

bool WidenedScene::face(const Picture& picture)
{
    const Sight sight{ray_map(picture.camera, picture.width, picture.height), picture.width, picture.height};
    if (sight_ == sight)
        return false;
    sight_ = sight;
    const ThinShapes shapes(sight.rays, sight.width, sight.height);
    for (const std::size_t i : instances_) {
        const scene::Instance& instance = source_.instances[i];
        widened_.meshes[at(widened_.instances[i].mesh)] =
            shapes.of(source_.meshes[at(instance.mesh)], instance.transform);
    }
    return true;
}

} // namespace lambent::view
