#version 450
#extension GL_GOOGLE_include_directive : require
#include "equations/in_glsl.glsl"
#include "equations/all.glsl"
#include "tests/equations/probes/probes.glsl"
#include "tests/equations/probes/probes_shading.glsl"

// One probe for each row of groups. Number k of probe p for point i is at (width p + k) points + i.
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Arguments { float arguments[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Results { float results[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    uint points = 64 * gl_NumWorkGroups.x;
    Inputs numbers = {arguments[i],              arguments[points + i],     arguments[2 * points + i],
                      arguments[3 * points + i], arguments[4 * points + i], arguments[5 * points + i],
                      arguments[6 * points + i], arguments[7 * points + i]};
    Outputs o = probe(int(gl_WorkGroupID.y), numbers);
    uint first = 4 * gl_WorkGroupID.y * points + i;
    results[first] = o.x;
    results[first + points] = o.y;
    results[first + 2 * points] = o.z;
    results[first + 3 * points] = o.w;
}
