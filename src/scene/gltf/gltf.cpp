#include "scene/gltf/gltf.h"

#include "base/file.h"
#include "scene/gltf/gltf_animation.h"
#include "scene/gltf_document/gltf_document.h"
#include "scene/gltf/gltf_image.h"
#include "scene/gltf/gltf_light.h"
#include "scene/gltf/gltf_mesh.h"
#include "scene/gltf/gltf_nodes.h"
#include "scene/gltf/gltf_pose.h"

#include <tbb/task_arena.h>

#include <mutex>
#include <utility>

namespace lambent::scene {
namespace {

// A scene whose images are not decoded yet, and the indices of these images in the file.
struct Stage {
    Scene scene;
    std::vector<int> images;
};

// The source for the glTF at a path, without its bytes.
GltfSource source_of(const std::filesystem::path& path, const Reach& reach)
{
    return {path.string(), {}, path.parent_path(), reach};
}

std::vector<AnimationInfo> infos_of(const std::vector<Animation>& animations)
{
    std::vector<AnimationInfo> infos;
    infos.reserve(animations.size());
    for (const Animation& animation : animations)
        infos.push_back(animation.info);
    return infos;
}

} // namespace

struct GltfFile::Opened {
    Opened(std::vector<std::uint8_t> own, const GltfSource& source, Warnings& warnings)
        : bytes(std::move(own)),
          document(open_document(bytes.empty() ? source : with_bytes(source), warnings)),
          animations(read_animations(document, warnings)), infos(infos_of(animations))
    {
    }

    Stage stage(const std::optional<Moment>& moment, const glm::dvec3& from, const ShapeStore& shapes,
                Warnings& warnings) const;
    Stage rest_stage(const ShapeStore& shapes, Warnings& warnings) const;
    void find_rest() const;
    void keep_image_index(const std::vector<int>& index) const;
    void find_image_index(const Stage& stage) const;

    std::vector<std::uint8_t> bytes; ///< of the file; empty if the caller holds them
    Document document;
    std::vector<Animation> animations;
    std::vector<AnimationInfo> infos;

    // Data that all poses share, computed for the first one.
    mutable std::once_flag rest_found;
    mutable StillShapes still;
    mutable Bounds rest_bounds;
    mutable glm::dvec3 origin{0.0};
    mutable std::once_flag images_read;
    mutable std::vector<int> image_index; ///< DecodedImages::index, the same for every stage

private:
    GltfSource with_bytes(GltfSource source) const
    {
        source.bytes = bytes;
        return source;
    }
};

// The scene with positions relative to the point `from` of the world.
Stage GltfFile::Opened::stage(const std::optional<Moment>& moment, const glm::dvec3& from,
                              const ShapeStore& shapes, Warnings& warnings) const
{
    NodeTree nodes = build_node_tree(document, pose_of(document, animations, moment), warnings);
    move_origin(nodes, from);
    DrawnMeshes drawn = read_meshes(document, nodes, shapes, warnings);
    Stage stage;
    stage.scene.origin = from;
    stage.scene.meshes = std::move(drawn.meshes);
    stage.scene.instances = std::move(drawn.instances);
    stage.scene.materials = std::move(drawn.materials.materials);
    stage.images = std::move(drawn.materials.images);
    stage.scene.cameras = read_cameras(document, nodes, warnings);
    stage.scene.lights = read_lights(document, nodes, warnings);
    stage.scene.animations = infos;
    return stage;
}

// The scene at rest, relative to its origin. This is found in several steps, from the world's origin: coordinates of
// scenes very far away are metres apart in floats there, and more exact from nearby.
Stage GltfFile::Opened::rest_stage(const ShapeStore& shapes, Warnings& warnings) const
{
    constexpr int most_steps = 4;
    glm::dvec3 from(0.0);
    Stage stage = this->stage(std::nullopt, from, shapes, warnings);
    for (int step = 1; step < most_steps; ++step) {
        const glm::dvec3 offset = better_origin(bounds(stage.scene));
        if (offset == glm::dvec3(0.0))
            break;
        from += offset;
        Warnings repeated;
        stage = this->stage(std::nullopt, from, shapes, repeated);
    }
    return stage;
}

void GltfFile::Opened::find_rest() const
{
    // Isolated: while it waits, this thread could otherwise run a task of another pose, which would wait for this call.
    tbb::this_task_arena::isolate([&] {
        std::call_once(rest_found, [&] {
            Warnings unread;
            const Stage rest = rest_stage({nullptr, &still}, unread);
            rest_bounds = bounds(rest.scene);
            origin = rest.scene.origin;
        });
    });
}

// The indices of images are known only once these are decoded. Usually scene() has done that before any pose is asked
// for.
void GltfFile::Opened::keep_image_index(const std::vector<int>& index) const
{
    std::call_once(images_read, [&] { image_index = index; });
}

void GltfFile::Opened::find_image_index(const Stage& stage) const
{
    tbb::this_task_arena::isolate([&] {
        std::call_once(images_read, [&] {
            Warnings unread;
            image_index = read_images(document, stage.images, unread).index;
        });
    });
}

GltfFile::GltfFile(const std::filesystem::path& path, Warnings& warnings, const Reach& reach)
    : opened_(std::make_unique<const Opened>(read_file(path), source_of(path, reach), warnings))
{
}

GltfFile::GltfFile(const GltfSource& source, Warnings& warnings)
    : opened_(std::make_unique<const Opened>(std::vector<std::uint8_t>(), source, warnings))
{
}

GltfFile::~GltfFile() = default;
GltfFile::GltfFile(GltfFile&&) noexcept = default;
GltfFile& GltfFile::operator=(GltfFile&&) noexcept = default;

const std::vector<AnimationInfo>& GltfFile::animations() const
{
    return opened_->infos;
}

const std::vector<std::filesystem::path>& GltfFile::files() const
{
    return opened_->document.beside;
}

Scene GltfFile::scene(const std::optional<Moment>& moment, Warnings& warnings) const
{
    ShapeStore shapes;
    if (moment) {
        opened_->find_rest();
        shapes.known = &opened_->still;
    }
    Stage stage = moment ? opened_->stage(moment, opened_->origin, shapes, warnings)
                         : opened_->rest_stage(shapes, warnings);
    if (moment)
        stage.scene.rest_bounds = opened_->rest_bounds;
    DecodedImages decoded = read_images(opened_->document, stage.images, warnings);
    opened_->keep_image_index(decoded.index);
    renumber_images(decoded.index, stage.scene.materials);
    stage.scene.images = std::move(decoded.images);
    if (stage.scene.instances.empty())
        warnings.push_back(text(opened_->document.file, ": nothing to draw"));
    return std::move(stage.scene);
}

Scene GltfFile::pose(const Moment& moment) const
{
    opened_->find_rest();
    Warnings unread;
    Stage stage = opened_->stage(moment, opened_->origin, {&opened_->still, nullptr}, unread);
    opened_->find_image_index(stage);
    renumber_images(opened_->image_index, stage.scene.materials);
    stage.scene.rest_bounds = opened_->rest_bounds;
    return std::move(stage.scene);
}

Scene load_gltf_bytes(const GltfSource& source, Warnings& warnings)
{
    return GltfFile(source, warnings).scene(std::nullopt, warnings);
}

Scene load_gltf(const std::filesystem::path& path, Warnings& warnings, const Reach& reach)
{
    return GltfFile(path, warnings, reach).scene(std::nullopt, warnings);
}

} // namespace lambent::scene
