#version 460
#extension GL_GOOGLE_include_directive : require
// Turns the looks of the listed pixels into fragments, one for all looks of a pixel that share their shading. It is shaded
// at the one of them that is nearest to their mean position. Wave 0 takes looks at edges, later waves those behind
// transparent surfaces.
#include "draw/vulkan/bindings.glsl"
#include "draw/vulkan/geometry.glsl"

layout(local_size_x = group_size_of_looks) in;
layout(constant_id = constant_looks) const int looks = 1;
layout(constant_id = constant_wave) const int wave = 0;

// For each look.
uvec2 id[looks];
vec3 front[looks];
bool faces[looks]; // whether it sees the front face
float weight[looks];
int owner[looks]; // the first look at the same surface; -1: none
// For each surface, at the index of its first look.
float sum[looks];
float area[looks]; // square pixels
vec2 mean[looks];
int best[looks];

// The share of the pixel that a look represents; negative if the look is not drawn.
float share_of(int look, uint pixel)
{
    if (wave == 0)
        return look == looks - 1 ? 0.0 : 1.0 / float(looks - 1);
    float left = behind[pixel * uint(looks) + uint(look)].y;
    return left > 0.0 ? left : -1.0;
}

float extent_of(int look, uint pixel)
{
    if (wave == 0)
        return look == looks - 1 ? 0.0 : picture.edges.z;
    return behind[pixel * uint(looks) + uint(look)].z;
}

// The least cosine between normals of looks at an instance that share their shading.
float least_cosine(uint instance)
{
    vec2 own = materials[instances[instance].ids.y].smoothness.xy;
    float roughness = picture.surfaces.x;
    float alpha = picture.surfaces.y > 0.0 ? own.y : roughness >= 0.0 ? roughness * roughness : own.x;
    return shared_cosine(alpha, picture.edges.y);
}

void face(int look, ivec2 pixel)
{
    id[look] = texelFetch(ids, ivec3(pixel - picture.apron.xy, look), 0).xy;
    if (id[look].x == nothing)
        return;
    Triangle triangle = triangle_of(id[look]);
    front[look] = front_of(triangle, id[look].x);
    faces[look] = dot(front[look], sight_through(vec2(pixel) + places[look]).direction) < 0.0;
}

bool share_shading(int a, int b, float least)
{
    return id[a].x == id[b].x &&
           (id[a].x == nothing || (faces[a] == faces[b] && dot(front[a], front[b]) > least));
}

// The first look that shares its shading with this one, by linear search. A new surface needs a positive weight; else -1.
int first_alike(int look)
{
    float least = least_cosine(id[look].x);
    for (int before = 0; before < look; ++before)
        if (owner[before] == before && share_shading(before, look, least))
            return before;
    return weight[look] > 0.0 ? look : -1;
}

// Whether the corners of a pixel share the shading of its centre: it then needs no other look.
bool is_uniform(ivec2 pixel)
{
    int middle = looks - 1;
    face(middle, pixel);
    float least = id[middle].x == nothing ? 0.0 : least_cosine(id[middle].x);
    for (int corner = 0; corner < 4; ++corner) {
        face(picture.corners[corner], pixel);
        if (!share_shading(picture.corners[corner], middle, least))
            return false;
    }
    return true;
}

void see(int look, uint index)
{
    int at = first_alike(look);
    owner[look] = at;
    if (at < 0)
        return;
    if (at == look) {
        sum[at] = 0.0;
        area[at] = 0.0;
        mean[at] = vec2(0.0);
        best[at] = look;
    }
    float extent = extent_of(look, index);
    sum[at] += weight[look];
    area[at] += extent * extent;
    mean[at] += weight[look] * places[look];
}

// Makes the look through the centre the only one. Returns the number of surfaces.
uint look_at_centre(inout float background)
{
    for (int look = 0; look < looks; ++look)
        owner[look] = -1;
    int middle = looks - 1;
    if (id[middle].x == nothing) {
        background += 1.0;
        return 0u;
    }
    owner[middle] = middle;
    best[middle] = middle;
    sum[middle] = 1.0;
    area[middle] = 1.0;
    return 1u;
}

// Returns the number of surfaces; adds the share of the pixel without a surface to `background`.
uint look_at_pixel(uint index, ivec2 pixel, inout float background)
{
    uint surfaces = 0u;
    for (int look = 0; look < looks; ++look) {
        owner[look] = -1;
        weight[look] = share_of(look, index);
        if (weight[look] < 0.0)
            continue;
        face(look, pixel);
        if (id[look].x == nothing)
            background += weight[look];
        else
            see(look, index);
        surfaces += owner[look] == look ? 1u : 0u;
    }
    for (int look = 0; look < looks; ++look) {
        int to = owner[look];
        if (to >= 0 && distance(places[look], mean[to] / sum[to]) < distance(places[best[to]], mean[to] / sum[to]))
            best[to] = look;
    }
    return surfaces;
}

void main()
{
    if (gl_GlobalInvocationID.x >= counters[counter_listed])
        return;
    uint index = listed[gl_GlobalInvocationID.x];
    uint width = uint(picture.tile.z);
    ivec2 pixel = picture.tile.xy + ivec2(index % width, index / width);
    float background = wave == 0 ? 0.0 : uintBitsToFloat(spans[index].z);
    bool uniform_pixel = wave == 0 && is_uniform(pixel);
    uint surfaces = uniform_pixel ? look_at_centre(background) : look_at_pixel(index, pixel, background);
    uint first = surfaces > 0u ? add_fragments(surfaces) : 0u;
    bool fits = first + surfaces <= uint(picture.fragments.x);
    spans[index] = uvec4(first, fits ? surfaces : 0u, floatBitsToUint(background), 0u);
    // A pixel that fits only in part is written up to the capacity: its fragments are shaded before the tile is drawn
    // again in parts.
    for (int look = 0; look < looks && first < uint(picture.fragments.x); ++look) {
        if (owner[look] != look)
            continue;
        int lit = best[look];
        records[first].ids = uvec4(id[lit], index, uint(lit));
        records[first].place = vec4(vec2(pixel) + places[lit], sum[look], sqrt(area[look]));
        ++first;
    }
}
