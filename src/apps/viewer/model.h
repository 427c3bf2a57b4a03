// A scene with its renderers, at any moment of its animations.
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
#include <tuple>
#include <vector>

namespace lambent::viewer {

/// Any thread may call the const functions except whole_scene(); pose(), renderer() and whole_scene() are for one
/// thread.
class Model {
public:
    /// Called with the files that a glTF refers to, before most of them are read.
    using NoteFiles = std::function<void(const std::vector<std::filesystem::path>&)>;

    /// Makes a built-in scene with the arguments' options for it, or reads a file; no animation is applied. `reach`:
    /// the files that a glTF may refer to. Throws Error.
    Model(const cli::RenderArguments& arguments, cli::RendererChoice backend, const NoteFiles& note = {},
          const scene::Reach& reach = {});

    /// The scene without animation.
    const scene::Scene& scene() const { return scene_; }
    const scene::Bounds& bounds() const { return bounds_; }
    const Warnings& warnings() const { return warnings_; }

    /// Lets all renderers draw the moment that the arguments name. Throws Error(usage) if there is no such animation.
    void pose(const cli::RenderArguments& arguments);

    /// The renderer for pictures with these settings, made on first use: each transfer has textures of its own, and
    /// bounces of light are drawn by the CPU. Throws Error(no_device).
    draw::Renderer& renderer(const draw::Settings& settings);

    /// The scene at the moment of the last pose(), with its textures; stays valid after the next pose().
    std::shared_ptr<const scene::Scene> whole_scene() const;

private:
    struct Needs {
        draw::TexelTransfer transfer;
        bool cpu;
        bool operator<(const Needs& other) const
        {
            return std::tie(transfer, cpu) < std::tie(other.transfer, other.cpu);
        }
    };
    draw::Renderer& renderer(const Needs& needs);

    std::unique_ptr<scene::GltfFile> file_; ///< null: built-in, or without animations
    Warnings warnings_;
    scene::Scene scene_;
    scene::Bounds bounds_;
    cli::RendererChoice backend_;
    std::optional<scene::Moment> moment_;
    std::unique_ptr<scene::Scene> posed_; ///< at moment_, without textures; null: no moment is set
    std::map<Needs, std::unique_ptr<draw::Renderer>> renderers_; ///< last: uses the scenes
};

} // namespace lambent::viewer
