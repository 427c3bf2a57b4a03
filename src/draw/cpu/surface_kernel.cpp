#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "draw/cpu/surface_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "draw/cpu/surface_kernel.h"

#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent::draw::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "draw/cpu/wide_fragments.h"
#include "shading/texture.glsl"
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function" // triangles are met by Embree
#include "shading/surface.glsl"
#pragma GCC diagnostic pop
#include "draw/cpu/wide_texture.h"

mat3 uniform(const glm::mat3& m)
{
    return mat3(uniform(m[0]), uniform(m[1]), uniform(m[2]));
}

// One attribute at the three corners of each lane's triangle.
template <int components>
struct Corners {
    alignas(64) float values[3][components][max_lanes];
};

// Reads an attribute array of the mesh: `components` floats per vertex.
template <int components, class Attribute>
void gather(const SurfaceContext& c, const std::vector<Attribute>& attribute, const uint32_t* triangles,
            Corners<components>& corners)
{
    for (size_t lane = 0; lane < lane_count; ++lane) {
        const glm::uvec3 triangle = c.mesh->triangles[triangles[lane]];
        for (int corner = 0; corner < 3; ++corner) {
            const float* from = &attribute[triangle[corner]][0];
            for (int i = 0; i < components; ++i)
                corners.values[corner][i][lane] = from[i];
        }
    }
}

template <int components>
vec3 corner3(const Corners<components>& corners, int corner)
{
    return vec3(load(corners.values[corner][0]), load(corners.values[corner][1]),
                load(corners.values[corner][2]));
}

template <int components>
Real interpolate(const Corners<components>& corners, int i, const Barycentric& at)
{
    return at.a * load(corners.values[0][i]) + at.b * load(corners.values[1][i]) +
           at.c * load(corners.values[2][i]);
}

template <int components>
vec3 interpolate3(const Corners<components>& corners, const Barycentric& at)
{
    return vec3(interpolate(corners, 0, at), interpolate(corners, 1, at), interpolate(corners, 2, at));
}

// The rate of change of an interpolated vector when the weights change by (b, c).
template <int components>
vec3 change(const Corners<components>& corners, Real b, Real c)
{
    return b * (corner3(corners, 1) - corner3(corners, 0)) + c * (corner3(corners, 2) - corner3(corners, 0));
}

SightRay sight_through(const RayMap& rays, Real x, Real y)
{
    return {uniform(rays.origin) + x * uniform(rays.origin_dx) + y * uniform(rays.origin_dy),
            uniform(rays.origin_dx),
            uniform(rays.origin_dy),
            uniform(rays.direction) + x * uniform(rays.direction_dx) + y * uniform(rays.direction_dy),
            uniform(rays.direction_dx),
            uniform(rays.direction_dy)};
}

Facet seen_facet(const SurfaceContext& c, const Fragments& f, size_t at, const SightRay& sight)
{
    Corners<3> corners;
    gather(c, c.mesh->positions, f.triangle.data() + at, corners);
    const mat3 linear = uniform(glm::mat3(c.transform));
    const Triangle triangle = {linear * corner3(corners, 0) + uniform(glm::vec3(c.transform[3])),
                               linear * (corner3(corners, 1) - corner3(corners, 0)),
                               linear * (corner3(corners, 2) - corner3(corners, 0))};
    const Meeting meeting = {load(f[hit_distance] + at), load(f[hit_u] + at), load(f[hit_v] + at)};
    return facet_at(sight, triangle, meeting);
}

Turning shading_normal(const SurfaceContext& c, const Fragments& f, size_t at, const Barycentric& weights)
{
    Corners<3> corners;
    gather(c, c.mesh->normals, f.triangle.data() + at, corners);
    const mat3 to_world = uniform(c.normals);
    return turning_of(to_world * interpolate3(corners, weights),
                      to_world * change(corners, weights.b_dx, weights.c_dx),
                      to_world * change(corners, weights.b_dy, weights.c_dy));
}

TexturePoint texture_point(const scene::TextureUse& use, const Corners<2>& corners, const Barycentric& at)
{
    const glm::mat3& m = use.transform;
    const auto coordinate = [](const Corners<2>& from, int corner) HWY_ATTR {
        return vec2(load(from.values[corner][0]), load(from.values[corner][1]));
    };
    const vec2 first = coordinate(corners, 0);
    const vec2 b = coordinate(corners, 1) - first, d = coordinate(corners, 2) - first;
    const vec2 column0(m[0][0], m[0][1]), column1(m[1][0], m[1][1]), column2(m[2][0], m[2][1]);
    const auto turned = [&](vec2 v) HWY_ATTR { return v.x * column0 + v.y * column1; };
    return {turned(first + at.b * b + at.c * d) + column2, turned(at.b_dx * b + at.c_dx * d),
            turned(at.b_dy * b + at.c_dy * d)};
}

// All that textures of one vector of fragments need.
struct Texturing {
    Barycentric at;
    Corners<2> sets[5]; // as TexcoordChoice has them

    Texturing(const SurfaceContext& c, const Fragments& f, size_t first, const Barycentric& weights)
        : at(weights)
    {
        for (int i = 0; i < c.texcoords.count; ++i) {
            const std::vector<glm::vec2>& set = *c.texcoords.sets[static_cast<size_t>(i)];
            if (!set.empty())
                gather(c, set, f.triangle.data() + first, sets[i]);
            else
                memset(&sets[i], 0, sizeof sets[i]);
        }
    }

    Color read(const PackedTexture* texture, const scene::TextureUse& use, int set, double otherwise,
               const MaskCut* mask = nullptr) const
    {
        if (!texture)
            return {otherwise, otherwise, otherwise, otherwise};
        return read_texture(*texture, texture_point(use, sets[set], at), mask);
    }
};

// The normal with its map, if there is one.
vec3 bumped(const SurfaceContext& c, const Fragments& f, size_t at, const Texturing& t, vec3 normal)
{
    if (!c.textures.normal || c.mesh->tangents.empty())
        return normal;
    Corners<4> corners;
    gather(c, c.mesh->tangents, f.triangle.data() + at, corners);
    const vec3 along = uniform(glm::mat3(c.transform)) * interpolate3(corners, t.at);
    const Color code = t.read(c.textures.normal, c.material->normal_texture, c.texcoords.normal, 0.0);
    return mapped_normal(normal, along, Real(c.handedness) * load(corners.values[0][3]),
                         vec3(code.r, code.g, code.b), c.material->normal_scale);
}

struct Material {
    Color base;
    Real metalness, roughness, occlusion;
    vec3 emitted;
};

// The base colour without the factor on its colour. Of masks, alpha is 1 where they are there, and where texels are smaller
// than pixels the share of them that is.
Color varying_color(const SurfaceContext& c, const Fragments& f, size_t at, const Texturing& t)
{
    const scene::Material& m = *c.material;
    Color vertex = {1.0, 1.0, 1.0, 1.0};
    if (!c.mesh->colors.empty()) {
        Corners<4> corners;
        gather(c, c.mesh->colors, f.triangle.data() + at, corners);
        vertex = {interpolate(corners, 0, t.at), interpolate(corners, 1, t.at), interpolate(corners, 2, t.at),
                  interpolate(corners, 3, t.at)};
    }
    const bool is_mask = m.alpha_mode == scene::AlphaMode::mask;
    MaskCut mask;
    store(vertex.a, mask.vertex);
    mask.factor = m.base_color.a, mask.cutoff = m.alpha_cutoff;
    const Color texel = t.read(c.textures.base_color, m.base_color_texture, c.texcoords.base_color, 1.0,
                               is_mask ? &mask : nullptr);
    Color color = {texel.r * vertex.r, texel.g * vertex.g, texel.b * vertex.b, texel.a};
    if (!is_mask)
        color.a = texel.a * vertex.a * Real(m.base_color.a);
    else if (!c.textures.base_color)
        color.a = select(vertex.a * Real(m.base_color.a) < Real(m.alpha_cutoff), 0.0, 1.0);
    return color;
}

Material material_at(const SurfaceContext& c, const Fragments& f, size_t at, const Texturing& t)
{
    const scene::Material& m = *c.material;
    Color base = varying_color(c, f, at, t);
    base.r *= Real(m.base_color.r);
    base.g *= Real(m.base_color.g);
    base.b *= Real(m.base_color.b);
    const Color rough = t.read(c.textures.metallic_roughness, m.metallic_roughness_texture,
                               c.texcoords.metallic_roughness, 1.0);
    const Color occlusion = t.read(c.textures.occlusion, m.occlusion_texture, c.texcoords.occlusion, 1.0);
    const Color emitted = t.read(c.textures.emissive, m.emissive_texture, c.texcoords.emissive, 1.0);
    return {base, clamp(rough.b * Real(m.metallic), 0.0, 1.0),
            c.roughness ? Real(*c.roughness) : clamp(rough.g * Real(m.perceptual_roughness), 0.0, 1.0),
            1.0 + Real(m.occlusion_strength) * (occlusion.r - 1.0),
            uniform(m.emissive) * vec3(emitted.r, emitted.g, emitted.b)};
}

// The report's parameters where they are given.
void store_phong(const SurfaceContext& c, const Material& m, size_t at, Fragments& f)
{
    const scene::PhongMaterial& given = c.material->phong;
    const Phong p = phong_from_metallic(vec3(m.base.r, m.base.g, m.base.b), m.metalness, m.roughness);
    store3(given.diffuse ? uniform(*given.diffuse) : p.diffuse, f, base_r, at);
    store3(given.specular ? uniform(*given.specular) : p.specular, f, specular_r, at);
    store(given.exponent ? Real(*given.exponent) : p.exponent, f[gloss] + at);
}

void store_material(const SurfaceContext& c, const Material& m, size_t at, Fragments& f)
{
    const scene::Material& material = *c.material;
    const vec3 base(m.base.r, m.base.g, m.base.b);
    store(m.metalness, f[metalness] + at);
    store(m.occlusion, f[occlusion] + at);
    store(material.alpha_mode == scene::AlphaMode::opaque ? Real(1.0) : m.base.a, f[opacity] + at);
    if (c.model == Model::phong) {
        store_phong(c, m, at, f);
    } else {
        store3(base, f, base_r, at);
        store3(base_reflectance(base, m.metalness), f, specular_r, at);
        store(alpha_of_roughness(m.roughness), f[gloss] + at);
    }
    store3(material.unlit ? base : m.emitted, f, emitted_r, at);
}

void find_surface(const SurfaceContext& c, size_t at, Fragments& f)
{
    const SightRay sight = sight_through(c.rays, load(f[place_x] + at), load(f[place_y] + at));
    const Facet facet = seen_facet(c, f, at, sight);
    const Texturing texturing(c, f, at, facet.at);
    const Turning turning = shading_normal(c, f, at, facet.at);
    const Surface surface =
        surface_at(sight, facet, turning, bumped(c, f, at, texturing, turning.normal), c.handedness);
    const Real part = load(f[extent] + at);
    store3(facet.position, f, position_x, at);
    store(surface.depth, f[depth] + at);
    store3(surface.view, f, view_x, at);
    store3(surface.normal, f, shading_x, at);
    store3(part * surface.mirrored_dx, f, mirrored_dx_x, at);
    store3(part * surface.mirrored_dy, f, mirrored_dy_x, at);
    store_material(c, material_at(c, f, at, texturing), at, f);
}

} // namespace

HWY_FLATTEN void find_surfaces(const SurfaceContext& context, size_t begin, size_t end, Fragments& fragments)
{
    for (size_t at = begin; at < end; at += lane_count)
        find_surface(context, at, fragments);
}

} // namespace lambent::draw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::draw {

HWY_EXPORT(find_surfaces);

void find_surfaces(const SurfaceContext& context, std::size_t begin, std::size_t end, Fragments& fragments)
{
    HWY_DYNAMIC_DISPATCH(find_surfaces)(context, begin, end, fragments);
}

} // namespace lambent::draw
#endif
