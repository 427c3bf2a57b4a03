#version 460
#extension GL_GOOGLE_include_directive : require
// Projects triangles by the camera rays of one look per pixel of a tile.
#define ONLY_READS
#include "draw/vulkan/bindings.glsl"

layout(location = 0) in vec3 position;
layout(location = 0) flat out uint instance_number;
layout(push_constant, std430) uniform Constants { RasterConstants raster; };

void main()
{
    InstanceRecord instance = instances[gl_InstanceIndex];
    vec4 p = vec4(position, 1.0);
    vec3 world = vec3(dot(instance.row_x, p), dot(instance.row_y, p), dot(instance.row_z, p));
    vec4 from_eye = vec4(world - picture.origin.xyz, 1.0);
    gl_Position = vec4(dot(raster.row_x, from_eye), dot(raster.row_y, from_eye), dot(raster.row_z, from_eye),
                       dot(raster.row_w, from_eye));
    instance_number = gl_InstanceIndex;
}
