#version 460
#extension GL_GOOGLE_include_directive : require
// The surface pass: position, normals and material of each fragment, from its triangle.
#include "draw/vulkan/bindings.glsl"
#include "draw/vulkan/geometry.glsl"
#include "draw/vulkan/textures.glsl"

layout(local_size_x = group_size) in;
layout(constant_id = constant_layered) const int layered = 1;
layout(constant_id = constant_model) const int model = model_ggx;
layout(constant_id = constant_textured) const int textured = 1;
#include "draw/vulkan/sources.glsl"
#include "shading/surface_pass.glsl"

void main()
{
    uint at = gl_GlobalInvocationID.x;
    if (at >= fragment_count())
        return;
    find_surface(Fragment(at), source_at(at), records[at].place.w);
    for (int column = column_direct; column < columns_of_light_end; ++column)
        store(Fragment(at), column, 0.0);
}
