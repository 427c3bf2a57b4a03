// A scene prepared for drawing: all data that do not change from picture to picture.
#pragma once

#include "draw/textures/scene_textures.h"
#include "draw/textures/typical_alpha.h"
#include "draw/cpu/surface_kernel.h"
#include "trace/visibility.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace lambent::draw {

using trace::Visibility;

class PreparedScene {
public:
    /// `posed` is `scene` or the same scene at another time; its images are not read. Both must outlive this.
    PreparedScene(const scene::Scene& scene, const scene::Scene& posed, TexelTransfer transfer);

    /// Changes to another time; textures are kept. `posed` must outlive this. Throws Error(no_device); then another
    /// pose() has to succeed before drawing.
    void pose(const scene::Scene& posed);

    const Visibility& visibility() const { return *visibility_; }

    /// Data shared by an instance's surfaces; the caller sets rays, model and the picture's other settings.
    const SurfaceContext& surface(std::uint32_t instance) const { return surfaces_[instance]; }

    /// How smooth an instance's surfaces are.
    const TypicalAlpha& typical_alpha(std::uint32_t instance) const
    {
        return alphas_[material_of_[instance]];
    }

    std::size_t instance_count() const { return surfaces_.size(); }

    /// Whether rays pass through the back faces of this instance.
    bool culls_back(std::uint32_t instance) const { return !surfaces_[instance].material->double_sided; }

private:
    SceneTextures textures_;
    std::optional<Visibility> visibility_;
    std::vector<SurfaceContext> surfaces_;
    std::vector<TypicalAlpha> alphas_;     ///< by material
    std::vector<std::size_t> material_of_; ///< by instance
};

} // namespace lambent::draw
