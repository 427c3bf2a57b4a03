#version 460
#extension GL_GOOGLE_include_directive : require
// Writes the instance and the triangle that a look sees; in later waves, of those behind the surface seen before.
#define ONLY_READS
#include "draw/vulkan/bindings.glsl"
#include "draw/vulkan/geometry.glsl"

layout(location = 0) flat in uint instance_number;
layout(location = 0) out uvec2 id;
layout(push_constant, std430) uniform Constants { RasterConstants raster; };
layout(constant_id = constant_looks) const int looks = 1;
layout(constant_id = constant_wave) const int wave = 0;

bool is_behind(ivec2 pixel)
{
    ivec2 at = pixel - picture.tile.xy;
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, picture.tile.zw)))
        return false;
    vec4 before = behind[(at.y * picture.tile.z + at.x) * looks + raster.look.x];
    if (before.y <= 0.0)
        return false;
    SightRay sight = sight_through(vec2(pixel) + places[raster.look.x]);
    Meeting meeting = meeting_with(sight, triangle_of(uvec2(instance_number, uint(gl_PrimitiveID))));
    return meeting.distance > before.x * (1.0 + 1.0e-5) + 1.0e-30;
}

void main()
{
    if (wave > 0 && !is_behind(ivec2(gl_FragCoord.xy) + picture.apron.xy))
        discard;
    id = uvec2(instance_number, uint(gl_PrimitiveID));
}
