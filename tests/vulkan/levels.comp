// Reads a cube texture by directions and levels, times a constant and a number that is pushed.
#version 450
layout(local_size_x = 1) in;
layout(constant_id = 0) const uint times = 1;
layout(push_constant) uniform Push { float offset; };
layout(set = 0, binding = 0) readonly buffer Places { vec4 places[]; };
layout(set = 0, binding = 1) uniform samplerCube light;
layout(set = 0, binding = 2) writeonly buffer Results { vec4 results[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    results[i] = float(times) * textureLod(light, places[i].xyz, places[i].w) + vec4(offset);
}
