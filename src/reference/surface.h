// Surface points at the hits of rays: position, normals and material, from the scene's own data.
#pragma once

#include "reference/material.h"
#include "scene/scene.h"
#include "trace/visibility.h"
#include "view/picture.h"

#include <optional>
#include <vector>

namespace lambent::reference {

/// A scene with the data of each instance that every hit needs. The scene must outlive it.
class Surfaces {
public:
    /// `roughness`: perceptual roughness of every surface, in place of its own. `lines`: a scene with the same
    /// instances, whose points and lines are triangles; null: the picture shows none. It must outlive this object
    /// too.
    Surfaces(const scene::Scene& scene, view::Model model, view::TexelTransfer transfer,
             std::optional<float> roughness = std::nullopt, const scene::Scene* lines = nullptr);

    /// The surface point of a hit, for a ray of unit direction.
    Surface at(const trace::Hit& hit, const glm::dvec3& direction) const;

    /// Whether camera rays pass through this hit, because it is the back of a one-sided surface.
    bool is_culled(const trace::Hit& hit) const;

    /// Opacity of the surface, 0 to 1, by its material's alpha. 1 for opaque materials, whose textures are not read.
    double opacity(const trace::Hit& hit) const;

private:
    struct Placed {
        const scene::Mesh* mesh;
        const scene::Material* material;
        glm::mat4 transform;
        glm::dmat3 normals; ///< transform of normals from mesh to world space
        double handedness;  ///< -1 if the transform mirrors, else 1
        bool is_line;       ///< points and lines, whose shading normal is their geometric normal too
    };
    struct Corners; ///< a triangle and the barycentric weights of a point
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
