#version 460
#extension GL_GOOGLE_include_directive : require
// Pixels without an edge take the look through their centre; pixels with an edge are listed for gather.comp.
#include "draw/vulkan/bindings.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = constant_looks) const int looks = 1;

shared uvec2 counts[64]; // fragments, edges
shared uvec2 group_first;

bool same_surface(int a, int b)
{
    uvec4 point_a = seen[2 * a];
    uvec4 point_b = seen[2 * b];
    if (point_a.w != point_b.w)
        return false;
    if (point_a.w == nothing)
        return true;
    uvec4 normal_a = seen[2 * a + 1];
    vec3 normal = uintBitsToFloat(normal_a.xyz);
    return dot(normal, uintBitsToFloat(seen[2 * b + 1].xyz)) > picture.edges.x &&
           abs(dot(uintBitsToFloat(point_b.xyz) - uintBitsToFloat(point_a.xyz), normal)) < uintBitsToFloat(normal_a.w);
}

// Whether an edge lies between the centre of a pixel of the apron and that of a neighbour.
bool is_edge(ivec2 at)
{
    ivec2 first = max(at - 1, ivec2(0));
    ivec2 last = min(at + 1, picture.apron.zw - 1);
    int middle = at.y * picture.apron.z + at.x;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
            if (!same_surface(middle, y * picture.apron.z + x))
                return true;
    return false;
}

// The indices of this pixel's fragment and of its listed edge. Those of a workgroup are consecutive.
uvec2 places_for(uvec2 own)
{
    uint me = gl_LocalInvocationIndex;
    counts[me] = own;
    barrier();
    if (me == 0u) {
        uvec2 all = uvec2(0u);
        for (int i = 0; i < 64; ++i) {
            uvec2 one = counts[i];
            counts[i] = all;
            all += one;
        }
        group_first = uvec2(0u);
        if (all.x > 0u)
            group_first.x = add_fragments(all.x);
        if (all.y > 0u)
            group_first.y = add_listed(all.y);
    }
    barrier();
    return group_first + counts[me];
}

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    bool there = all(lessThan(at, picture.tile.zw));
    ivec2 in_apron = at + picture.tile.xy - picture.apron.xy;
    uint index = uint(at.y * picture.tile.z + at.x);
    bool edge = there && looks > 1 && is_edge(in_apron);
    uvec2 id = uvec2(nothing);
    if (there && !edge)
        id = texelFetch(ids, ivec3(in_apron, looks - 1), 0).xy;
    bool found = id.x != nothing;
    uvec2 place = places_for(uvec2(found ? 1u : 0u, edge ? 1u : 0u));
    if (edge)
        listed[place.y] = index;
    else if (there)
        spans[index] = uvec4(place.x, found ? 1u : 0u, floatBitsToUint(found ? 0.0 : 1.0), 0u);
    if (!found || place.x >= uint(picture.fragments.x))
        return;
    records[place.x].ids = uvec4(id, index, uint(looks - 1));
    records[place.x].place = vec4(vec2(at + picture.tile.xy) + 0.5, 1.0, 1.0);
}
