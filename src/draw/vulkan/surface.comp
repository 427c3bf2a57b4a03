#version 460
#extension GL_GOOGLE_include_directive : require
// From fragments' triangles to their surfaces: position, normal, material.
#include "draw/vulkan/bindings.glsl"
#include "draw/vulkan/geometry.glsl"
#include "draw/vulkan/textures.glsl"

layout(local_size_x = group_size) in;
layout(constant_id = constant_model) const int model = model_ggx;
layout(constant_id = constant_textured) const int textured = 1;

// A triangle's corners in its mesh, and where in it.
struct Place {
    InstanceRecord instance;
    MeshRecord mesh;
    uvec3 corners;
    Barycentric at;
};

vec3 vectors_at(Place p, uint words_at, vec3 weights)
{
    return weights.x * words3(words_at + 3u * p.corners.x) + weights.y * words3(words_at + 3u * p.corners.y) +
           weights.z * words3(words_at + 3u * p.corners.z);
}

vec4 fours_at(Place p, uint words_at)
{
    return p.at.a * words4(words_at + 4u * p.corners.x) + p.at.b * words4(words_at + 4u * p.corners.y) +
           p.at.c * words4(words_at + 4u * p.corners.z);
}

Turning shading_normal(Place p)
{
    uint words_at = p.mesh.vectors.y;
    vec3 sum = vectors_at(p, words_at, vec3(p.at.a, p.at.b, p.at.c));
    vec3 dx = vectors_at(p, words_at, vec3(-p.at.b_dx - p.at.c_dx, p.at.b_dx, p.at.c_dx));
    vec3 dy = vectors_at(p, words_at, vec3(-p.at.b_dy - p.at.c_dy, p.at.b_dy, p.at.c_dy));
    return turning_of(world_normal(p.instance, sum), world_normal(p.instance, dx), world_normal(p.instance, dy));
}

vec2 transformed(UseRecord use, vec2 v) { return vec2(dot(use.row_u.xy, v), dot(use.row_v.xy, v)); }

TexturePoint texture_point(UseRecord use, uint set, Place p)
{
    vec2 first = vec2(0.0);
    vec2 b = vec2(0.0);
    vec2 c = vec2(0.0);
    if (set != no_words) {
        first = words2(set + 2u * p.corners.x);
        b = words2(set + 2u * p.corners.y) - first;
        c = words2(set + 2u * p.corners.z) - first;
    }
    return TexturePoint(transformed(use, first + p.at.b * b + p.at.c * c) + vec2(use.row_u.z, use.row_v.z),
                        transformed(use, p.at.b_dx * b + p.at.c_dx * c), transformed(use, p.at.b_dy * b + p.at.c_dy * c));
}

const int use_count = 5;

// All of a material's textures, 1 where it has none. One loop: compilers take their time over them.
void read_textures(uint material, Place p, vec4 vertex, out vec4 read[use_count])
{
    MaskCut mask = MaskCut(false, vertex.a, materials[material].base_color.a, materials[material].numbers.w);
    for (int i = 0; i < use_count; ++i) {
        mask.used = i == use_base_color && materials[material].kind.x == alpha_mask;
        UseRecord use = materials[material].uses[i];
        read[i] = vec4(1.0);
        if (textured == 1 && use.ids.x >= 0)
            read[i] = read_texture(use.ids.x, texture_point(use, i < 4 ? p.instance.sets[i] : p.instance.ids.z, p), mask);
        else if (mask.used)
            read[i].a = there(mask, 1.0);
    }
}

vec3 bumped(uint material, Place p, vec3 normal, vec4 code)
{
    if (materials[material].uses[use_normal].ids.x < 0 || p.mesh.vectors.z == no_words)
        return normal;
    vec3 along = world_vector(p.instance, fours_at(p, p.mesh.vectors.z).xyz);
    float side = p.instance.normal_z.w * word(p.mesh.vectors.z + 4u * p.corners.x + 3u);
    return mapped_normal(normal, along, side, code.rgb, materials[material].emissive.w);
}

void store_phong(uint material, Phong phong, uint at)
{
    vec4 diffuse = materials[material].phong_diffuse;
    vec4 specular = materials[material].phong_specular;
    vec4 exponent = materials[material].phong_exponent;
    store3(diffuse.w == 1.0 ? diffuse.rgb : phong.diffuse, column_base, at);
    store3(specular.w == 1.0 ? specular.rgb : phong.specular, column_specular, at);
    store(exponent.y == 1.0 ? exponent.x : phong.exponent, column_gloss, at);
}

// Of masks, alpha is what their texture was read as: 1 where they are there, and where texels are smaller than pixels the
// share of them that is.
void store_material(uint material, vec4 vertex, vec4 read[use_count], uint at)
{
    vec4 base = materials[material].base_color * read[use_base_color] * vertex;
    vec4 numbers = materials[material].numbers;
    float metalness = clamp(read[use_metallic_roughness].b * numbers.x, 0.0, 1.0);
    float roughness = picture.surfaces.x;
    if (roughness < 0.0)
        roughness = clamp(read[use_metallic_roughness].g * numbers.y, 0.0, 1.0);
    ivec4 kind = materials[material].kind;
    store(metalness, column_metalness, at);
    store(1.0 + numbers.z * (read[use_occlusion].r - 1.0), column_occlusion, at);
    float opacity = kind.x == alpha_mask ? read[use_base_color].a : base.a;
    store(kind.x == alpha_opaque ? 1.0 : opacity, column_opacity, at);
    if (model == model_phong) {
        store_phong(material, phong_from_metallic(base.rgb, metalness, roughness), at);
    } else {
        store3(base.rgb, column_base, at);
        store3(base_reflectance(base.rgb, metalness), column_specular, at);
        store(alpha_of_roughness(roughness), column_gloss, at);
    }
    store3(kind.y == 1 ? base.rgb : materials[material].emissive.rgb * read[use_emissive].rgb, column_emitted, at);
    store(kind.y == 1 ? 0.0 : 1.0, column_lit, at);
}

void main()
{
    uint at = gl_GlobalInvocationID.x;
    if (at >= fragment_count())
        return;
    FragmentRecord record = records[at];
    InstanceRecord instance = instances[record.ids.x];
    MeshRecord mesh = meshes[instance.ids.x];
    uvec3 corners = corners_of(mesh, record.ids.y);
    SightRay sight = sight_through(record.place.xy);
    Triangle triangle = triangle_of(instance, mesh, corners);
    Facet facet = facet_at(sight, triangle, meeting_with(sight, triangle));
    Place place = Place(instance, mesh, corners, facet.at);
    Turning turning = shading_normal(place);
    vec4 read[use_count];
    vec4 vertex = mesh.vectors.w == no_words ? vec4(1.0) : fours_at(place, mesh.vectors.w);
    read_textures(instance.ids.y, place, vertex, read);
    vec3 normal = bumped(instance.ids.y, place, turning.normal, read[use_normal]);
    Surface surface = surface_at(sight, facet, turning, normal, instance.normal_z.w);
    store3(facet.position, column_position, at);
    store(surface.depth, column_depth, at);
    store3(surface.view, column_view, at);
    store3(surface.normal, column_normal, at);
    store3(record.place.w * surface.mirrored_dx, column_mirrored_dx, at);
    store3(record.place.w * surface.mirrored_dy, column_mirrored_dy, at);
    store_material(instance.ids.y, vertex, read, at);
    for (int column = column_direct; column < column_depth; ++column)
        store(0.0, column, at);
}
