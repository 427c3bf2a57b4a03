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
#include "draw/cpu/wide_texture.h"

// Smallest alpha: below it a lobe is narrower than float arithmetic tells apart.
constexpr double least_alpha = 1.0e-4;

// A shading normal that faces further away from the viewer than this is bent towards him.
constexpr double least_view_cosine = 1.0e-3;

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

// Weights of the three corners, and how those of corners 1 and 2 change to the next pixel right and below.
struct Barycentric {
    Real a, b, c;
    Real b_dx, c_dx, b_dy, c_dy;
};

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

// A ray of sight and its neighbours'.
struct Sight {
    vec3 origin_dx, origin_dy, direction, direction_dx, direction_dy;
};

Sight sight_through(const RayMap& rays, Real x, Real y)
{
    return {uniform(rays.origin_dx), uniform(rays.origin_dy),
            uniform(rays.direction) + x * uniform(rays.direction_dx) + y * uniform(rays.direction_dy),
            uniform(rays.direction_dx), uniform(rays.direction_dy)};
}

// The triangle in the world and the point that is seen.
struct Facet {
    vec3 position, normal; // normal: counter-clockwise side of the world's triangle, not normalised
    Barycentric at;
};

// How far the seen point moves on the triangle's plane when the ray moves. [Igehy 1999, "Tracing ray differentials"]
vec3 moved_on_plane(const Sight& s, vec3 normal, Real distance, vec3 origin_step, vec3 direction_step)
{
    const vec3 step = origin_step + distance * direction_step;
    const Real towards = dot(s.direction, normal);
    const Real safe = select(abs(towards) < 1.0e-30, 1.0e-30, towards);
    return step - (dot(step, normal) / safe) * s.direction;
}

Real largest_part(vec3 v)
{
    return max(abs(v.x), max(abs(v.y), abs(v.z)));
}

// A rate of change, or 0 where it overflowed: what is looked up by it has to be a number.
Real believed(Real rate)
{
    return select(abs(rate) < 1.0e15, rate, 0.0);
}

Facet facet_at(const SurfaceContext& c, const Fragments& f, size_t at, const Sight& sight)
{
    Corners<3> corners;
    gather(c, c.mesh->positions, f.triangle.data() + at, corners);
    const mat3 linear = uniform(glm::mat3(c.transform));
    const vec3 origin = linear * corner3(corners, 0) + uniform(glm::vec3(c.transform[3]));
    const vec3 edge1 = linear * (corner3(corners, 1) - corner3(corners, 0));
    const vec3 edge2 = linear * (corner3(corners, 2) - corner3(corners, 0));
    // In units of the triangle's size: the fourth powers of the edges that follow leave the range of floats early.
    const Real unit = reciprocal(clamp(max(largest_part(edge1), largest_part(edge2)), 1.0e-30, 1.0e30));
    const vec3 e1 = unit * edge1, e2 = unit * edge2;
    const vec3 normal = cross(e1, e2);
    const Real u = load(f[hit_u] + at), v = load(f[hit_v] + at), distance = load(f[hit_distance] + at);
    const Real scale = unit / max(dot(normal, normal), 1.0e-36);
    const vec3 dx = moved_on_plane(sight, normal, distance, sight.origin_dx, sight.direction_dx);
    const vec3 dy = moved_on_plane(sight, normal, distance, sight.origin_dy, sight.direction_dy);
    const vec3 across_b = scale * cross(e2, normal), across_c = scale * cross(normal, e1);
    const Barycentric weights{1.0 - u - v,
                              u,
                              v,
                              believed(dot(dx, across_b)),
                              believed(dot(dx, across_c)),
                              believed(dot(dy, across_b)),
                              believed(dot(dy, across_c))};
    return {origin + u * edge1 + v * edge2, normal, weights};
}

// A shading normal and how it turns to the next pixel right and below.
struct Turning {
    vec3 normal, dx, dy;
};

Turning shading_normal(const SurfaceContext& c, const Fragments& f, size_t at, const Barycentric& weights)
{
    Corners<3> corners;
    gather(c, c.mesh->normals, f.triangle.data() + at, corners);
    const mat3 to_world = uniform(c.normals);
    const vec3 sum = to_world * interpolate3(corners, weights);
    const Real inverse = inversesqrt(max(dot(sum, sum), 1.0e-30));
    const vec3 normal = inverse * sum;
    const vec3 dx = inverse * (to_world * change(corners, weights.b_dx, weights.c_dx));
    const vec3 dy = inverse * (to_world * change(corners, weights.b_dy, weights.c_dy));
    return {normal, dx - dot(normal, dx) * normal, dy - dot(normal, dy) * normal};
}

TexturePoint texture_point(const scene::TextureUse& use, const Corners<2>* sets, const Barycentric& at)
{
    const Corners<2>& corners = sets[use.texcoord];
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
    Corners<2> sets[2];

    Texturing(const SurfaceContext& c, const Fragments& f, size_t first, const Barycentric& weights)
        : at(weights)
    {
        for (int set = 0; set < 2; ++set)
            if (!c.mesh->texcoords[set].empty())
                gather(c, c.mesh->texcoords[set], f.triangle.data() + first, sets[set]);
            else
                memset(&sets[set], 0, sizeof sets[set]);
    }

    Color read(const PackedTexture* texture, const scene::TextureUse& use, double otherwise) const
    {
        if (!texture)
            return {otherwise, otherwise, otherwise, otherwise};
        return read_texture(*texture, texture_point(use, sets, at));
    }
};

// The normal that a normal map asks for, in the frame of the interpolated tangent. [glTF 2.0, 3.9.3]
vec3 mapped_normal(const SurfaceContext& c, const Fragments& f, size_t at, const Texturing& t, vec3 normal)
{
    if (!c.textures.normal || c.mesh->tangents.empty())
        return normal;
    Corners<4> corners;
    gather(c, c.mesh->tangents, f.triangle.data() + at, corners);
    // Of unit length, or the bumps would grow and shrink with the mesh.
    const vec3 along = uniform(glm::mat3(c.transform)) * interpolate3(corners, t.at);
    const vec3 tangent = inversesqrt(max(dot(along, along), 1.0e-30)) * along;
    const vec3 bitangent = (Real(c.handedness) * load(corners.values[0][3])) * cross(normal, tangent);
    const Color code = t.read(c.textures.normal, c.material->normal_texture, 0.0);
    const Real scale = c.material->normal_scale;
    const vec3 mapped = ((2.0 * code.r - 1.0) * scale) * tangent +
                        ((2.0 * code.g - 1.0) * scale) * bitangent + (2.0 * code.b - 1.0) * normal;
    const Real length2 = dot(mapped, mapped);
    return select(length2 > 1.0e-12, inversesqrt(max(length2, 1.0e-12)) * mapped, normal);
}

// Change of the mirrored direction from that of view and normal. V = -direction / |direction|.
vec3 mirrored_change(vec3 normal, vec3 view, vec3 normal_change, vec3 view_change)
{
    const Real cosine_change = dot(normal_change, view) + dot(normal, view_change);
    const vec3 d = 2.0 * (cosine_change * normal + dot(normal, view) * normal_change) - view_change;
    // A footprint of half the sky says that the triangle is seen edge on; more than that says nothing.
    const Real length2 = dot(d, d);
    return select(length2 > 1.0, inversesqrt(max(length2, 1.0)) * d, d);
}

struct Material {
    Color base;
    Real metalness, roughness, occlusion;
    vec3 emitted;
};

Material material_at(const SurfaceContext& c, const Fragments& f, size_t at, const Texturing& t)
{
    const scene::Material& m = *c.material;
    Color base = t.read(c.textures.base_color, m.base_color_texture, 1.0);
    if (!c.mesh->colors.empty()) {
        Corners<4> corners;
        gather(c, c.mesh->colors, f.triangle.data() + at, corners);
        base.r *= interpolate(corners, 0, t.at);
        base.g *= interpolate(corners, 1, t.at);
        base.b *= interpolate(corners, 2, t.at);
        base.a *= interpolate(corners, 3, t.at);
    }
    base.r *= Real(m.base_color.r);
    base.g *= Real(m.base_color.g);
    base.b *= Real(m.base_color.b);
    base.a *= Real(m.base_color.a);
    const Color rough = t.read(c.textures.metallic_roughness, m.metallic_roughness_texture, 1.0);
    const Color occlusion = t.read(c.textures.occlusion, m.occlusion_texture, 1.0);
    const Color emitted = t.read(c.textures.emissive, m.emissive_texture, 1.0);
    return {base, clamp(rough.b * Real(m.metallic), 0.0, 1.0),
            clamp(rough.g * Real(m.perceptual_roughness), 0.0, 1.0),
            1.0 + Real(m.occlusion_strength) * (occlusion.r - 1.0),
            uniform(m.emissive) * vec3(emitted.r, emitted.g, emitted.b)};
}

// The report's parameters: given, or as near as its model comes to metal and dielectric.
void store_phong(const SurfaceContext& c, const Material& m, size_t at, Fragments& f)
{
    const vec3 base(m.base.r, m.base.g, m.base.b);
    const scene::PhongMaterial& given = c.material->phong;
    const vec3 diffuse = given.diffuse ? uniform(*given.diffuse) : (1.0 - m.metalness) * base;
    const vec3 specular = given.specular ? uniform(*given.specular) : base_reflectance(base, m.metalness);
    const Real exponent = given.exponent ? Real(*given.exponent) : phong_exponent(m.roughness * m.roughness);
    store3(diffuse, f, base_r, at);
    store3(specular, f, specular_r, at);
    store(exponent, f[gloss] + at);
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
        store(max(m.roughness * m.roughness, least_alpha), f[gloss] + at);
    }
    store3(material.unlit ? base : m.emitted, f, emitted_r, at);
}

void find_surface(const SurfaceContext& c, size_t at, Fragments& f)
{
    const Sight sight = sight_through(c.rays, load(f[place_x] + at), load(f[place_y] + at));
    const Facet facet = facet_at(c, f, at, sight);
    const Texturing texturing(c, f, at, facet.at);
    Turning turning = shading_normal(c, f, at, facet.at);

    const Real length = inversesqrt(max(dot(sight.direction, sight.direction), 1.0e-30));
    const vec3 view = -(length * sight.direction);
    const auto view_change = [&](vec3 step) HWY_ATTR { return -(length * (step - dot(step, view) * view)); };

    const Mask behind = Real(c.handedness) * dot(facet.normal, view) < 0.0;
    const vec3 mapped = mapped_normal(c, f, at, texturing, turning.normal);
    const vec3 normal = facing_normal(select(behind, -mapped, mapped), view, least_view_cosine);
    const Real side = select(behind, -1.0, 1.0);

    store3(facet.position, f, position_x, at);
    store(load(f[hit_distance] + at) * sqrt(dot(sight.direction, sight.direction)), f[depth] + at);
    store3(view, f, view_x, at);
    store3(normal, f, shading_x, at);
    const Real part = load(f[extent] + at);
    store3(part * mirrored_change(normal, view, side * turning.dx, view_change(sight.direction_dx)), f,
           mirrored_dx_x, at);
    store3(part * mirrored_change(normal, view, side * turning.dy, view_change(sight.direction_dy)), f,
           mirrored_dy_x, at);
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
