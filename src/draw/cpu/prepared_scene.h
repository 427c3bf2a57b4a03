// A scene with all that does not change from picture to picture worked out.
#pragma once

#include "draw/textures/scene_textures.h"
#include "draw/cpu/surface_kernel.h"
#include "trace/visibility.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace lambent::draw {

using trace::Visibility;

class PreparedScene {
public:
    /// `posed` is the scene or it at another moment, whose images are not looked at. Both must outlive it.
    PreparedScene(const scene::Scene& scene, const scene::Scene& posed, TexelTransfer transfer);

    /// Goes on to another moment; textures stay. The scene must outlive it. Throws Error(no_device), and must then be
    /// posed again before it is drawn.
    void pose(const scene::Scene& posed);

    const Visibility& visibility() const { return *visibility_; }

    /// What the surfaces of an instance share; rays and model are left to the caller.
    const SurfaceContext& surface(std::uint32_t instance) const { return surfaces_[instance]; }

    /// Whether a ray that meets the back of this instance goes on.
    bool culls_back(std::uint32_t instance) const { return !surfaces_[instance].material->double_sided; }

private:
    SceneTextures textures_;
    std::optional<Visibility> visibility_;
    std::vector<SurfaceContext> surfaces_;
};

} // namespace lambent::draw
