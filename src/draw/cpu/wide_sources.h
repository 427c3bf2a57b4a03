// Hooks of src/shading/README.md for the surface pass, in SIMD lanes. Included after wide/wide.h, shading/points.glsl,
// wide_fragments.h and wide_texture.h, inside the target's namespace: no guard.

mat3 uniform(const glm::mat3& m)
{
    return mat3(uniform(m[0]), uniform(m[1]), uniform(m[2]));
}

// One vertex attribute at the three corners of each lane's triangle.
template <int components>
struct LaneCorners {
    alignas(64) float values[3][components][max_lanes];
};

// Reads an attribute array of the mesh: `components` floats per vertex.
template <int components, class Attribute>
void gather(const SurfaceContext& c, const std::vector<Attribute>& attribute, const uint32_t* triangles,
            LaneCorners<components>& corners)
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
vec3 corner3(const LaneCorners<components>& corners, int corner)
{
    return vec3(load(corners.values[corner][0]), load(corners.values[corner][1]),
                load(corners.values[corner][2]));
}

template <int components>
Real interpolate(const LaneCorners<components>& corners, int i, const Barycentric& at)
{
    return at.a * load(corners.values[0][i]) + at.b * load(corners.values[1][i]) +
           at.c * load(corners.values[2][i]);
}

// Fragments of one instance, one per lane.
struct Source {
    const SurfaceContext* context;
    Fragment fragment;
    const uint32_t* triangles; // index in the mesh, per lane
};

template <int components, class Attribute>
LaneCorners<components> corners_of(const Source& s, const std::vector<Attribute>& attribute)
{
    LaneCorners<components> corners;
    gather(*s.context, attribute, s.triangles, corners);
    return corners;
}

HWY_INLINE int model_of(const Source& s)
{
    return s.context->model == Model::phong ? model_phong : model_ggx;
}

HWY_INLINE Real compensation_of(const Source& s)
{
    return s.context->energy_compensation ? 1.0 : 0.0;
}

// The ray by which a fragment was met, other than a camera ray.
HWY_INLINE SightRay own_ray(const Source& s)
{
    const vec3 direction = load3(s.fragment, met_along);
    const Real spread = load(s.fragment, met_spread);
    const mat3 frame = orthonormal_frame(direction);
    return {load3(s.fragment, met_from), vec3(0.0), vec3(0.0), direction, spread * frame.x, spread * frame.y};
}

HWY_INLINE SightRay sight_of(const Source& s)
{
    if (s.context->met_by_rays)
        return own_ray(s);
    const RayMap& rays = s.context->rays;
    const Real x = load(s.fragment, place_x), y = load(s.fragment, place_y);
    return {uniform(rays.origin) + x * uniform(rays.origin_dx) + y * uniform(rays.origin_dy),
            uniform(rays.origin_dx),
            uniform(rays.origin_dy),
            uniform(rays.direction) + x * uniform(rays.direction_dx) + y * uniform(rays.direction_dy),
            uniform(rays.direction_dx),
            uniform(rays.direction_dy)};
}

HWY_INLINE Triangle triangle_of(const Source& s)
{
    const SurfaceContext& c = *s.context;
    const LaneCorners<3> corners = corners_of<3>(s, c.mesh->positions);
    const mat3 linear = uniform(glm::mat3(c.transform));
    return {linear * corner3(corners, 0) + uniform(glm::vec3(c.transform[3])),
            linear * (corner3(corners, 1) - corner3(corners, 0)),
            linear * (corner3(corners, 2) - corner3(corners, 0))};
}

// The intersection that Embree found.
HWY_INLINE Meeting meeting_of(const Source& s, const SightRay&, const Triangle&)
{
    return {load(s.fragment, hit_distance), load(s.fragment, hit_u), load(s.fragment, hit_v)};
}

HWY_INLINE Corners corner_normals(const Source& s)
{
    const LaneCorners<3> corners = corners_of<3>(s, s.context->mesh->normals);
    return {corner3(corners, 0), corner3(corners, 1), corner3(corners, 2)};
}

HWY_INLINE mat3 normals_to_world(const Source& s)
{
    return uniform(s.context->normals);
}

HWY_INLINE Real handedness(const Source& s)
{
    return s.context->handedness;
}

HWY_INLINE Texel vertex_color(const Source& s, const Barycentric& at)
{
    if (s.context->mesh->colors.empty())
        return {1.0, 1.0, 1.0, 1.0};
    const LaneCorners<4> corners = corners_of<4>(s, s.context->mesh->colors);
    return {interpolate(corners, 0, at), interpolate(corners, 1, at), interpolate(corners, 2, at),
            interpolate(corners, 3, at)};
}

TexturePoint texture_point(const scene::TextureUse& use, const LaneCorners<2>& corners, const Barycentric& at)
{
    const glm::mat3& m = use.transform;
    const auto coordinate = [](const LaneCorners<2>& from, int corner) HWY_ATTR {
        return vec2(load(from.values[corner][0]), load(from.values[corner][1]));
    };
    const vec2 first = coordinate(corners, 0);
    const vec2 b = coordinate(corners, 1) - first, d = coordinate(corners, 2) - first;
    const vec2 column0(m[0][0], m[0][1]), column1(m[1][0], m[1][1]), column2(m[2][0], m[2][1]);
    const auto turned = [&](vec2 v) HWY_ATTR { return v.x * column0 + v.y * column1; };
    return {turned(first + at.b * b + at.c * d) + column2, turned(at.b_dx * b + at.c_dx * d),
            turned(at.b_dy * b + at.c_dy * d)};
}

// Reads a material's textures at one vector of fragments; each set of coordinates is gathered once.
class TextureReader {
public:
    TextureReader(const Source& s, const Barycentric& at) : context_(*s.context), at_(at)
    {
        for (int i = 0; i < context_.texcoords.count; ++i) {
            const std::vector<glm::vec2>& set = *context_.texcoords.sets[static_cast<size_t>(i)];
            if (!set.empty())
                gather(context_, set, s.triangles, sets_[i]);
            else
                memset(&sets_[i], 0, sizeof sets_[i]);
        }
    }

    Texel read(size_t number, const MaskCut* mask = nullptr) const
    {
        const PackedTexture* const texture = context_.textures[number];
        if (!texture)
            return {1.0, 1.0, 1.0, 1.0};
        return read_texture(
            *texture, texture_point(*context_.uses[number], sets_[context_.texcoords.of[number]], at_), mask);
    }

    // For masks, alpha is the opaque share.
    Texel read_base_color(const Texel& vertex) const
    {
        const scene::Material& m = *context_.material;
        if (m.alpha_mode != scene::AlphaMode::mask)
            return read(texture_base_color);
        MaskCut mask;
        store(vertex.a, mask.vertex);
        mask.factor = m.base_color.a, mask.cutoff = m.alpha_cutoff;
        Texel texel = read(texture_base_color, &mask);
        if (!context_.textures[texture_base_color])
            texel.a = select(vertex.a * Real(m.base_color.a) < Real(m.alpha_cutoff), 0.0, 1.0);
        return texel;
    }

private:
    const SurfaceContext& context_;
    Barycentric at_;
    LaneCorners<2> sets_[texture_count]; // in the order of TexcoordChoice::sets
};

Texels texels_of(const Source& s, const Barycentric& at, const Texel& vertex)
{
    const TextureReader reader(s, at);
    const auto read = [&](size_t number) HWY_ATTR {
        return number == texture_base_color ? reader.read_base_color(vertex) : reader.read(number);
    };
    return {
#define TEXTURE(name, number, transfer, object, key) read(number),
#define NORMAL_TEXTURE(name, number, object, key) read(number),
#include "shading/material/textures.h"
    };
}

Material factors_of(const Source& s)
{
    const scene::Material& m = *s.context->material;
    return {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture)                                    \
    uniform(glm::vec3(m.name)), Real(m.name.a),
#define COLOR(name, number, value, object, key, texture) uniform(m.name),
#define SCALAR(name, number, value, object, key, texture, channel) Real(m.name),
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) Real(m.factor),
#define STRENGTH(name, factor, number, value, object, key, texture, channel) Real(m.factor),
#include "shading/material/parameters.h"
    };
}

HWY_INLINE int alpha_mode(const Source& s)
{
    return static_cast<int>(s.context->material->alpha_mode);
}

HWY_INLINE Real own_or_given_alpha(const Source& s, Real own)
{
    return s.context->roughness ? alpha_of_roughness(*s.context->roughness) : own;
}

HWY_INLINE int is_unlit(const Source& s)
{
    return s.context->material->unlit ? 1 : 0;
}

HWY_INLINE int has_normal_map(const Source& s, int texture)
{
    return s.context->textures[static_cast<size_t>(texture)] && !s.context->mesh->tangents.empty() ? 1 : 0;
}

HWY_INLINE Real normal_scale(const Source& s, int texture)
{
    return s.context->normal_scales[static_cast<size_t>(texture)];
}

vec3 tangent_at(const Source& s, const Barycentric& at)
{
    const LaneCorners<4> corners = corners_of<4>(s, s.context->mesh->tangents);
    return uniform(glm::mat3(s.context->transform)) *
           vec3(interpolate(corners, 0, at), interpolate(corners, 1, at), interpolate(corners, 2, at));
}

// The sign of the first corner's bitangent, negated where the transform mirrors.
HWY_INLINE Real tangent_side(const Source& s)
{
    const LaneCorners<4> corners = corners_of<4>(s, s.context->mesh->tangents);
    return Real(s.context->handedness) * load(corners.values[0][3]);
}

HWY_INLINE GivenPhong given_phong(const Source& s)
{
    const scene::PhongMaterial& g = s.context->material->phong;
    const auto share = [](bool is_given) HWY_ATTR -> Real { return is_given ? 1.0 : 0.0; };
    return {uniform(g.diffuse.value_or(glm::vec3(0.0f))), uniform(g.specular.value_or(glm::vec3(0.0f))),
            g.exponent.value_or(0.0f),
            vec3(share(g.diffuse.has_value()), share(g.specular.has_value()), share(g.exponent.has_value()))};
}
