#version 450
#extension GL_GOOGLE_include_directive : require
// Compiled, never run: the text must also be good for fragment shaders.
#include "equations/in_glsl.glsl"
#include "equations/all.glsl"
#include "tests/equations/probes/probes.glsl"
#include "tests/equations/probes/probes_shading.glsl"

layout(location = 0) in vec4 first;
layout(location = 1) in vec4 second;
layout(location = 0) out vec4 colour;

void main()
{
    Inputs numbers = {first.x, first.y, first.z, first.w, second.x, second.y, second.z, second.w};
    Outputs o = probe(int(gl_FragCoord.x), numbers);
    colour = vec4(o.x, o.y, o.z, o.w);
}
