#include "reference/surface.h"

#include "equations/in_double.h"
#include "reference/texture.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace lambent::reference {
namespace {

// As the renderers have it: below this a lobe is narrower than float arithmetic tells apart, and a normal that faces
// further away is bent towards the viewer.
constexpr double least_alpha = 1.0e-4, least_view_cosine = 1.0e-3;

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise)
{
    const double length = glm::length(v);
    return length > 1e-150 ? v / length : otherwise;
}

} // namespace

struct Surfaces::Corners {
    const scene::Mesh& mesh;
    glm::uvec3 index;
    glm::dvec3 weight;

    Corners(const scene::Mesh& m, const trace::Hit& hit)
        : mesh(m), index(m.triangles[hit.triangle]),
          weight(1.0 - static_cast<double>(hit.u) - static_cast<double>(hit.v), static_cast<double>(hit.u),
                 static_cast<double>(hit.v))
    {
    }

    template <class Attribute>
    auto of(const std::vector<Attribute>& values) const
    {
        using Wide = glm::vec<Attribute::length(), double, glm::defaultp>;
        return weight.x * Wide(values[index.x]) + weight.y * Wide(values[index.y]) +
               weight.z * Wide(values[index.z]);
    }
};

Surfaces::Surfaces(const scene::Scene& scene, view::Model model, view::TexelTransfer transfer,
                   std::optional<float> roughness, const scene::Scene* lines)
    : scene_(scene), model_(model), transfer_(transfer), roughness_(roughness)
{
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const bool is_line = has_lines(scene.meshes[static_cast<std::size_t>(scene.instances[i].mesh)]);
        const scene::Scene& from = is_line && lines ? *lines : scene;
        const scene::Instance& instance = from.instances[i];
        const scene::Mesh& mesh = from.meshes[static_cast<std::size_t>(instance.mesh)];
        const int material = instance.material >= 0 ? instance.material : mesh.material;
        const glm::dmat3 linear(instance.transform);
        placed_.push_back({&mesh, &scene.materials[static_cast<std::size_t>(material)], instance.transform,
                           glm::transpose(glm::inverse(linear)), glm::determinant(linear) < 0.0 ? -1.0 : 1.0,
                           is_line});
    }
}

bool Surfaces::is_culled(const trace::Hit& hit) const
{
    return !hit.front && !placed_[hit.instance].material->double_sided;
}

glm::dvec4 Surfaces::read(const scene::TextureUse& use, view::TexelTransfer transfer, const Corners& c) const
{
    const auto& set = c.mesh.texcoords[use.texcoord];
    if (use.image < 0)
        return glm::dvec4(1.0);
    const glm::dvec2 uv = set.empty() ? glm::dvec2(0.0) : c.of(set);
    const glm::dvec3 moved = glm::dmat3(use.transform) * glm::dvec3(uv, 1.0);
    return read_texture(scene_.images[static_cast<std::size_t>(use.image)], use.sampler, transfer,
                        glm::dvec2(moved));
}

glm::dvec4 Surfaces::base_color(const Placed& placed, const Corners& c) const
{
    glm::dvec4 color =
        glm::dvec4(placed.material->base_color) * read(placed.material->base_color_texture, transfer_, c);
    if (!c.mesh.colors.empty())
        color *= c.of(c.mesh.colors);
    return color;
}

double Surfaces::opacity(const trace::Hit& hit) const
{
    const Placed& placed = placed_[hit.instance];
    const scene::Material& material = *placed.material;
    if (material.alpha_mode == scene::AlphaMode::opaque)
        return 1.0;
    const double alpha = base_color(placed, Corners(*placed.mesh, hit)).a;
    if (material.alpha_mode == scene::AlphaMode::mask)
        return alpha >= static_cast<double>(material.alpha_cutoff) ? 1.0 : 0.0;
    return std::clamp(alpha, 0.0, 1.0);
}

// In the world, on the side that the mesh's own normals are on; with the normal map. [glTF 2.0, 3.9.3]
glm::dvec3 Surfaces::shading_normal(const Placed& placed, const Corners& c) const
{
    const glm::dvec3 normal = unit_or(placed.normals * c.of(c.mesh.normals), glm::dvec3(0.0, 1.0, 0.0));
    const scene::TextureUse& use = placed.material->normal_texture;
    if (use.image < 0 || c.mesh.tangents.empty())
        return normal;
    const glm::dvec3 tangent =
        unit_or(glm::dmat3(placed.transform) * glm::dvec3(c.of(c.mesh.tangents)), glm::dvec3(1.0, 0.0, 0.0));
    const double side = placed.handedness * static_cast<double>(c.mesh.tangents[c.index.x].w);
    const glm::dvec3 bitangent = side * glm::cross(normal, tangent);
    const glm::dvec3 code = glm::dvec3(read(use, view::TexelTransfer::none, c)) * 2.0 - 1.0;
    const double scale = placed.material->normal_scale;
    return unit_or(scale * code.x * tangent + scale * code.y * bitangent + code.z * normal, normal);
}

void Surfaces::fill_phong(const scene::Material& material, double roughness, Surface& surface) const
{
    const scene::PhongMaterial& given = material.phong;
    const in_double::vec3 base(surface.base.x, surface.base.y, surface.base.z);
    const in_double::vec3 F0 = in_double::base_reflectance(base, surface.metalness);
    surface.specular = given.specular ? glm::dvec3(*given.specular) : glm::dvec3(F0.x, F0.y, F0.z);
    surface.gloss = given.exponent ? static_cast<double>(*given.exponent)
                                   : in_double::phong_exponent(roughness * roughness);
    surface.base = given.diffuse ? glm::dvec3(*given.diffuse) : (1.0 - surface.metalness) * surface.base;
}

double Surfaces::roughness_of(const scene::Material& material, double texel) const
{
    if (roughness_)
        return static_cast<double>(*roughness_);
    return std::clamp(texel * static_cast<double>(material.perceptual_roughness), 0.0, 1.0);
}

void Surfaces::fill_material(const Placed& placed, const Corners& c, Surface& surface) const
{
    const scene::Material& m = *placed.material;
    surface.base = glm::dvec3(base_color(placed, c));
    const glm::dvec4 rough = read(m.metallic_roughness_texture, view::TexelTransfer::none, c);
    const double roughness = roughness_of(m, rough.g);
    surface.metalness = std::clamp(rough.b * static_cast<double>(m.metallic), 0.0, 1.0);
    surface.unlit = m.unlit;
    surface.emitted =
        m.unlit ? surface.base : glm::dvec3(m.emissive) * glm::dvec3(read(m.emissive_texture, transfer_, c));
    surface.gloss = std::max(roughness * roughness, least_alpha);
    if (model_ == view::Model::phong)
        fill_phong(m, roughness, surface);
}

Surface Surfaces::at(const trace::Hit& hit, const glm::dvec3& direction) const
{
    const Placed& placed = placed_[hit.instance];
    const Corners corners(*placed.mesh, hit);
    Surface surface;
    surface.position =
        glm::dvec3(glm::dmat4(placed.transform) * glm::dvec4(corners.of(placed.mesh->positions), 1.0));
    surface.view = -direction;
    const double side = hit.front ? 1.0 : -1.0;
    surface.geometric = side * glm::dvec3(hit.normal);
    const glm::dvec3 normal = side * shading_normal(placed, corners);
    const in_double::vec3 facing = in_double::facing_normal(
        {normal.x, normal.y, normal.z}, {surface.view.x, surface.view.y, surface.view.z}, least_view_cosine);
    surface.normal = {facing.x, facing.y, facing.z};
    if (placed.is_line)
        surface.geometric = surface.normal;
    fill_material(placed, corners, surface);
    return surface;
}

} // namespace lambent::reference
