// The hooks of src/shading/README.md for the surface pass, on a device. Included after geometry.glsl and textures.glsl.

// A triangle's corners in its mesh, and the position in the picture where it is seen.
struct Source {
    uint instance;
    uint material;
    MeshRecord mesh;
    uvec3 corners;
    vec2 place;
};

Source source_at(uint at)
{
    FragmentRecord record = records[at];
    uvec4 ids = instances[record.ids.x].ids;
    MeshRecord mesh = meshes[ids.x];
    return Source(record.ids.x, ids.y, mesh, corners_of(mesh, record.ids.y), record.place.xy);
}

int has_layers() { return layered; }
int model_of(Source s) { return model; }
float compensation_of(Source s) { return picture.rotation.w; }
SightRay sight_of(Source s) { return sight_through(s.place); }
Triangle triangle_of(Source s) { return triangle_of(instances[s.instance], s.mesh, s.corners); }
Meeting meeting_of(Source s, SightRay sight, Triangle triangle) { return meeting_with(sight, triangle); }
float handedness(Source s) { return instances[s.instance].normal_z.w; }

Corners corner_normals(Source s)
{
    uint words_at = s.mesh.vectors.y;
    return Corners(words3(words_at + 3u * s.corners.x), words3(words_at + 3u * s.corners.y), words3(words_at + 3u * s.corners.z));
}

mat3 normals_to_world(Source s)
{
    return transpose(mat3(instances[s.instance].normal_x.xyz, instances[s.instance].normal_y.xyz, instances[s.instance].normal_z.xyz));
}

vec4 fours_at(Source s, Barycentric at, uint words_at)
{
    return at.a * words4(words_at + 4u * s.corners.x) + at.b * words4(words_at + 4u * s.corners.y) +
           at.c * words4(words_at + 4u * s.corners.z);
}

Texel texel_from(vec4 v) { return Texel(v.r, v.g, v.b, v.a); }

Texel vertex_color(Source s, Barycentric at)
{
    return s.mesh.vectors.w == no_words ? Texel(1.0, 1.0, 1.0, 1.0) : texel_from(fours_at(s, at, s.mesh.vectors.w));
}

vec2 transformed(UseRecord use, vec2 v) { return vec2(dot(use.row_u.xy, v), dot(use.row_v.xy, v)); }

TexturePoint texture_point(Source s, UseRecord use, uint set, Barycentric at)
{
    vec2 first = vec2(0.0);
    vec2 b = vec2(0.0);
    vec2 c = vec2(0.0);
    if (set != no_words) {
        first = words2(set + 2u * s.corners.x);
        b = words2(set + 2u * s.corners.y) - first;
        c = words2(set + 2u * s.corners.z) - first;
    }
    return TexturePoint(transformed(use, first + at.b * b + at.c * c) + vec2(use.row_u.z, use.row_v.z),
                        transformed(use, at.b_dx * b + at.c_dx * c), transformed(use, at.b_dy * b + at.c_dy * c));
}

// 1 for textures that the material lacks; for masks, alpha is the opaque share. One loop over the material's textures,
// because unrolled reads are slow to compile, and some devices run a branch that no lane takes.
Texels texels_of(Source s, Barycentric at, Texel vertex)
{
    uint material = s.material;
    bool is_mask = materials[material].kind.x == alpha_mask;
    MaskCut mask = MaskCut(is_mask, vertex.a, materials[material].factors[3], materials[material].phong_exponent.z);
    vec4 read[texture_count];
    for (int i = 0; i < texture_count; ++i)
        read[i] = vec4(1.0);
    if (is_mask)
        read[texture_base_color].a = there(mask, 1.0);
    for (int k = 0; textured == 1 && k < materials[material].kind.z; ++k) {
        int i = materials[material].used[k];
        UseRecord use = materials[material].uses[i];
        mask.used = is_mask && i == texture_base_color;
        read[i] = read_texture(use.ids.x, texture_point(s, use, instances[s.instance].sets[i], at), mask);
    }
    Texels t = {
#define TEXTURE(name, number, transfer, object, key) texel_from(read[number]),
#define NORMAL_TEXTURE(name, number, object, key) texel_from(read[number]),
#include "shading/material/textures.h"
    };
    return t;
}

float factor(Source s, int number) { return materials[s.material].factors[number]; }
vec3 factor3(Source s, int number) { return vec3(factor(s, number), factor(s, number + 1), factor(s, number + 2)); }

Material factors_of(Source s)
{
    Material m = {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) factor3(s, number), factor(s, number + 3),
#define COLOR(name, number, value, object, key, texture) factor3(s, number),
#define SCALAR(name, number, value, object, key, texture, channel) factor(s, number),
#define ROUGHNESS(name, factor_name, number, value, object, key, texture, channel) factor(s, number),
#define STRENGTH(name, factor_name, number, value, object, key, texture, channel) factor(s, number),
#include "shading/material/parameters.h"
    };
    return m;
}

int alpha_mode(Source s) { return materials[s.material].kind.x; }
int is_unlit(Source s) { return materials[s.material].kind.y; }

float own_or_given_alpha(Source s, float own)
{
    return picture.surfaces.x < 0.0 ? own : alpha_of_roughness(picture.surfaces.x);
}

int has_normal_map(Source s, int texture)
{
    return materials[s.material].uses[texture].ids.x >= 0 && s.mesh.vectors.z != no_words ? 1 : 0;
}

float normal_scale(Source s, int texture) { return materials[s.material].normal_scales[texture]; }
vec3 tangent_at(Source s, Barycentric at) { return world_vector(instances[s.instance], fours_at(s, at, s.mesh.vectors.z).xyz); }

float tangent_side(Source s)
{
    return instances[s.instance].normal_z.w * word(s.mesh.vectors.z + 4u * s.corners.x + 3u);
}

GivenPhong given_phong(Source s)
{
    vec4 diffuse = materials[s.material].phong_diffuse;
    vec4 specular = materials[s.material].phong_specular;
    vec4 exponent = materials[s.material].phong_exponent;
    return GivenPhong(diffuse.rgb, specular.rgb, exponent.x, vec3(diffuse.w, specular.w, exponent.y));
}
