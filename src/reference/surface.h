// What a ray has met: the point, its normals and its material, from the scene's own data.
#pragma once

#include "reference/material.h"
#include "scene/scene.h"
#include "trace/visibility.h"
#include "view/picture.h"

#include <optional>
#include <vector>

namespace lambent::reference {

/// A scene with the few numbers per instance that every hit needs. The scene must outlive it.
class Surfaces {
public:
    /// `roughness`: perceptual, of every surface, instead of its own. `lines`: the scene's points and lines as triangles, in
    /// the instances that show some; none: they are not there. It must outlive this, too.
    Surfaces(const scene::Scene& scene, view::Model model, view::TexelTransfer transfer,
             std::optional<float> roughness = std::nullopt, const scene::Scene* lines = nullptr);

    /// The point that a ray of unit direction has met.
    Surface at(const trace::Hit& hit, const glm::dvec3& direction) const;

    /// Whether rays of sight that meet this go on: the back of a surface that has only a front.
    bool is_culled(const trace::Hit& hit) const;

    /// Share of the surface that is there, 0 to 1, by its material's alpha. 1 without a look at textures where opaque.
    double opacity(const trace::Hit& hit) const;

private:
    struct Placed {
        const scene::Mesh* mesh;
        const scene::Material* material;
        glm::mat4 transform;
        glm::dmat3 normals; ///< world from mesh, for normals
        double handedness;  ///< -1: mirrored
        bool is_line;       ///< which has no side but its normal's
    };
    struct Corners; ///< a triangle and the weights of its corners
    glm::dvec4 read(const scene::TextureUse& use, view::TexelTransfer transfer, const Corners& c) const;
    glm::dvec4 base_color(const Placed& placed, const Corners& c) const;
    struct NormalMap {
        const scene::TextureUse& use;
        double scale;
    };
    glm::dvec3 mesh_normal(const Placed& placed, const Corners& c) const;
    glm::dvec3 mapped_normal(const Placed& placed, const Corners& c, const NormalMap& map) const;
    static glm::dvec3 facing(const glm::dvec3& normal, const glm::dvec3& view);
    void fill_material(const Placed& placed, const Corners& c, Surface& surface) const;
    void fill_phong(const scene::Material& material, Surface& surface) const;
    void fill_layers(const Placed& placed, const Corners& c, double side, Surface& surface) const;

    const scene::Scene& scene_;
    view::Model model_;
    view::TexelTransfer transfer_;
    std::optional<float> roughness_;
    std::vector<Placed> placed_;
};

} // namespace lambent::reference
