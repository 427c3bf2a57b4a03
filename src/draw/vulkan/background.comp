#version 460
#extension GL_GOOGLE_include_directive : require
// Adds the background to pixels that surfaces do not cover. Alpha remains the coverage by surfaces.
#include "draw/vulkan/bindings.glsl"
#include "draw/vulkan/hooks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = constant_looks) const int looks = 1;
layout(constant_id = constant_through) const int through = 1;

int has_layers() { return 0; }
int model_of(Environment e) { return model_ggx; }
int levels_of(Environment e) { return picture.panorama.y > 0.0 ? levels_pipeline : levels_matched; }

#include "shading/all.glsl"
#include "shading/light_passes.glsl"

vec3 light_behind(vec2 place)
{
    if (picture.behind.x == background_color)
        return picture.background.rgb;
    return background_light(Environment(picture.samples.x, 0, picture.fragments.w),
                            normalize(picture.direction.xyz + place.x * picture.direction_dx.xyz +
                                      place.y * picture.direction_dy.xyz));
}

void main()
{
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(place, picture.tile.zw)))
        return;
    int pixel = place.y * picture.tile.z + place.x;
    int pixels = picture.tile.z * picture.tile.w;
    // Looks that are still transparent after the last wave show the background.
    float share = uintBitsToFloat(spans[pixel].z);
    for (int look = 0; through == 1 && look < looks; ++look)
        share += behind[pixel * looks + look].y;
    if (share <= 0.0 || picture.behind.x == background_none)
        return;
    vec4 light = vec4(share * light_behind(vec2(place + picture.tile.xy) + 0.5), 0.0);
    drawn[pixel] += light;
    for (int layer = 0; layer < picture.samples.z; ++layer) // that of the background
        if (picture.layers[layer / 4][layer % 4] < 0)
            drawn[(layer + 1) * pixels + pixel] += light;
}
