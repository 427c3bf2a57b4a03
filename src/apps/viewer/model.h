// A scene ready to be drawn, at any moment of its animations.
#pragma once

#include "apps/options/arguments.h"
#include "apps/common/make_renderer.h"
#include "base/error.h"
#include "draw/renderer.h"
#include "scene/gltf/gltf.h"
#include "scene/scene.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace lambent::viewer {

/// Immutable but for pose(), renderer() and whole_scene(), which one thread alone may call.
class Model {
public:
    /// Told of the files beside a scene's own that it is read from, before most of them are read.
    using NoteFiles = std::function<void(const std::vector<std::filesystem::path>&)>;

    /// A built-in scene or a file, with the arguments' options for built-in shapes; it stands as the file has it.
    /// `reach`: how far what the file names may lead. Throws Error.
    Model(const cli::RenderArguments& arguments, cli::RendererChoice backend, const NoteFiles& note = {},
          const scene::Reach& reach = {});

    /// As it stands without animation.
    const scene::Scene& scene() const { return scene_; }
    const scene::Bounds& bounds() const { return bounds_; }
    const Warnings& warnings() const { return warnings_; }

    /// From now on renderers draw the moment that the arguments name. Throws Error(usage) where there is none such.
    void pose(const cli::RenderArguments& arguments);

    /// One for each transfer, made when first asked for, as each keeps textures of its own. Throws Error(no_device).
    draw::Renderer& renderer(draw::TexelTransfer transfer);

    /// The scene of that moment with its textures, for others than the renderers; it outlives the next pose().
    std::shared_ptr<const scene::Scene> whole_scene() const;

private:
    std::unique_ptr<scene::GltfFile> file_; ///< null: built-in
    Warnings warnings_;
    scene::Scene scene_;
    scene::Bounds bounds_;
    cli::RendererChoice backend_;
    std::optional<scene::Moment> moment_;
    std::unique_ptr<scene::Scene> posed_; ///< at moment_, without textures; null: at none
    std::map<draw::TexelTransfer, std::unique_ptr<draw::Renderer>> renderers_; ///< last: they use the scenes
};

} // namespace lambent::viewer
