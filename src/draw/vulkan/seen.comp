#version 460
#extension GL_GOOGLE_include_directive : require
// The surface at the centre of each pixel, for edge detection.
#include "draw/vulkan/bindings.glsl"
#include "draw/vulkan/geometry.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = constant_looks) const int looks = 1;

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, picture.apron.zw)))
        return;
    int pixel = 2 * (at.y * picture.apron.z + at.x);
    uvec2 id = texelFetch(ids, ivec3(at, looks - 1), 0).xy;
    seen[pixel] = uvec4(0u, 0u, 0u, nothing);
    if (id.x == nothing)
        return;
    SightRay sight = sight_through(vec2(at + picture.apron.xy) + 0.5);
    Triangle triangle = triangle_of(id);
    Meeting meeting = meeting_with(sight, triangle);
    vec3 point = sight.origin + meeting.distance * sight.direction;
    float pixel_width = length(sight.origin_dx + meeting.distance * sight.direction_dx);
    seen[pixel] = uvec4(floatBitsToUint(point), id.x);
    seen[pixel + 1] = uvec4(floatBitsToUint(front_of(triangle, id.x)), floatBitsToUint(pixel_width));
}
