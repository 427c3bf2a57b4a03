// A scene's triangles, and camera rays. Included after bindings.glsl.
#include "shading/points.glsl"

float word(uint at) { return uintBitsToFloat(Words(picture.addresses.xy).words[at]); }
vec2 words2(uint at) { return vec2(word(at), word(at + 1u)); }
vec3 words3(uint at) { return vec3(word(at), word(at + 1u), word(at + 2u)); }
vec4 words4(uint at) { return vec4(words3(at), word(at + 3u)); }

uvec3 corners_of(MeshRecord mesh, uint triangle)
{
    Words geometry = Words(picture.addresses.xy);
    uint at = mesh.others.x + 3u * triangle;
    return uvec3(geometry.words[at], geometry.words[at + 1u], geometry.words[at + 2u]);
}

vec3 world_vector(InstanceRecord i, vec3 v) { return vec3(dot(i.row_x.xyz, v), dot(i.row_y.xyz, v), dot(i.row_z.xyz, v)); }

vec3 world_normal(InstanceRecord i, vec3 v)
{
    return vec3(dot(i.normal_x.xyz, v), dot(i.normal_y.xyz, v), dot(i.normal_z.xyz, v));
}

Triangle triangle_of(InstanceRecord instance, MeshRecord mesh, uvec3 corners)
{
    vec3 a = words3(mesh.vectors.x + 3u * corners.x);
    vec3 b = words3(mesh.vectors.x + 3u * corners.y);
    vec3 c = words3(mesh.vectors.x + 3u * corners.z);
    vec3 origin = vec3(instance.row_x.w, instance.row_y.w, instance.row_z.w);
    return Triangle(world_vector(instance, a) + origin, world_vector(instance, b - a), world_vector(instance, c - a));
}

Triangle triangle_of(uvec2 id)
{
    InstanceRecord instance = instances[id.x];
    MeshRecord mesh = meshes[instance.ids.x];
    return triangle_of(instance, mesh, corners_of(mesh, id.y));
}

SightRay sight_through(vec2 place)
{
    return SightRay(picture.origin.xyz + place.x * picture.origin_dx.xyz + place.y * picture.origin_dy.xyz,
                    picture.origin_dx.xyz, picture.origin_dy.xyz,
                    picture.direction.xyz + place.x * picture.direction_dx.xyz + place.y * picture.direction_dy.xyz,
                    picture.direction_dx.xyz, picture.direction_dy.xyz);
}

// The unit normal of a triangle's front face, accurate for all sizes of triangles.
vec3 front_of(Triangle t, uint instance)
{
    float unit = 1.0 / clamp(max(largest_part(t.edge1), largest_part(t.edge2)), 1.0e-30, 1.0e30);
    vec3 n = cross(unit * t.edge1, unit * t.edge2);
    return (instances[instance].normal_z.w * inversesqrt(max(dot(n, n), 1.0e-30))) * n;
}
