#include "reference/surface.h"

#include "reference/material_in_double.h"
#include "reference/texture.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace lambent::reference {
namespace {

// Least cosine between a shading normal and the view, as in the renderers: other normals are bent towards the viewer.
constexpr double least_view_cosine = 1.0e-3;

in_double::Texel texel(const glm::dvec4& v)
{
    return {v.r, v.g, v.b, v.a};
}

in_double::Material factors(const scene::Material& m)
{
    return {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture)                                    \
    to_text(glm::dvec3(m.name)), static_cast<double>(m.name.a),
#define COLOR(name, number, value, object, key, texture) to_text(glm::dvec3(m.name)),
#define SCALAR(name, number, value, object, key, texture, channel) static_cast<double>(m.name),
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) static_cast<double>(m.factor),
#define STRENGTH(name, factor, number, value, object, key, texture, channel) static_cast<double>(m.factor),
#include "shading/material/parameters.h"
    };
}

glm::dvec3 given_or(const std::optional<glm::vec3>& given, const in_double::vec3& made)
{
    return given ? glm::dvec3(*given) : from_text(made);
}

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

// Interpolated normal in world space, on the side of the mesh's own normals.
glm::dvec3 Surfaces::mesh_normal(const Placed& placed, const Corners& c) const
{
    return unit_or(placed.normals * c.of(c.mesh.normals), glm::dvec3(0.0, 1.0, 0.0));
}

// The same with the normal map applied, if there is one. [glTF 2.0, 3.9.3]
glm::dvec3 Surfaces::mapped_normal(const Placed& placed, const Corners& c, const NormalMap& map) const
{
    const glm::dvec3 normal = mesh_normal(placed, c);
    if (map.use.image < 0 || c.mesh.tangents.empty())
        return normal;
    const glm::dvec3 tangent =
        unit_or(glm::dmat3(placed.transform) * glm::dvec3(c.of(c.mesh.tangents)), glm::dvec3(1.0, 0.0, 0.0));
    const double side = placed.handedness * static_cast<double>(c.mesh.tangents[c.index.x].w);
    const glm::dvec3 bitangent = side * glm::cross(normal, tangent);
    const glm::dvec3 code = glm::dvec3(read(map.use, view::TexelTransfer::none, c)) * 2.0 - 1.0;
    return unit_or(map.scale * code.x * tangent + map.scale * code.y * bitangent + code.z * normal, normal);
}

glm::dvec3 Surfaces::facing(const glm::dvec3& normal, const glm::dvec3& view)
{
    return from_text(in_double::facing_normal(to_text(normal), to_text(view), least_view_cosine));
}

void Surfaces::fill_phong(const scene::Material& material, Surface& surface) const
{
    const scene::PhongMaterial& given = material.phong;
    const PointMaterial& m = surface.material;
    const in_double::Phong made = in_double::phong_from_metallic(to_text(m.base_color), m.metallic, m.alpha);
    surface.phong.diffuse = given_or(given.diffuse, made.diffuse);
    surface.phong.specular = given_or(given.specular, made.specular);
    surface.phong.exponent = given.exponent ? static_cast<double>(*given.exponent) : made.exponent;
}

// The material's opacity is set to 1, because rays ask for it separately, by opacity().
void Surfaces::fill_material(const Placed& placed, const Corners& c, Surface& surface) const
{
    const scene::Material& m = *placed.material;
    const auto codes = [&](scene::TextureCodes kind) {
        return kind == scene::TextureCodes::color ? transfer_ : view::TexelTransfer::none;
    };
    const in_double::Texels texels = {
#define TEXTURE(name, number, transfer, object, key)                                                         \
    texel(read(m.name##_texture, codes(scene::TextureCodes::transfer), c)),
#define NORMAL_TEXTURE(name, number, object, key) texel(glm::dvec4(1.0)),
#include "shading/material/textures.h"
    };
    const glm::dvec4 vertex = c.mesh.colors.empty() ? glm::dvec4(1.0) : c.of(c.mesh.colors);
    surface.material =
        from_text(in_double::material_of(factors(m), texels, texel(vertex), in_double::alpha_opaque));
    if (roughness_)
        surface.material.alpha = in_double::alpha_of_roughness(static_cast<double>(*roughness_));
    surface.unlit = m.unlit;
    if (model_ == view::Model::phong)
        fill_phong(m, surface);
}

void Surfaces::fill_layers([[maybe_unused]] const Placed& placed, [[maybe_unused]] const Corners& c,
                           [[maybe_unused]] double side, [[maybe_unused]] Surface& surface) const
{
#define LAYER(name, number, normal)                                                                          \
    if (surface.material.name > 0.0)                                                                         \
        surface.layers.push_back(                                                                            \
            {number, facing(side * mapped_normal(placed, c,                                                  \
                                                 {placed.material->normal##_texture,                         \
                                                  static_cast<double>(placed.material->normal##_scale)}),    \
                            surface.view)});
#include "shading/lobes/layers.h"
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
    const NormalMap map = {placed.material->normal_texture,
                           static_cast<double>(placed.material->normal_scale)};
    surface.normal = facing(side * mapped_normal(placed, corners, map), surface.view);
    if (placed.is_line)
        surface.geometric = surface.normal;
    fill_material(placed, corners, surface);
    if (model_ == view::Model::ggx)
        fill_layers(placed, corners, side, surface);
    return surface;
}

} // namespace lambent::reference
