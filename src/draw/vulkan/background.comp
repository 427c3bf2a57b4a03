#version 460
#extension GL_GOOGLE_include_directive : require
// What is behind everything, where something of it is seen. Coverage stays that of the surfaces.
#include "draw/vulkan/bindings.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = constant_looks) const int looks = 1;
layout(constant_id = constant_through) const int through = 1;

// A texel of the panorama before its scale; rows beyond a pole go on across it.
vec3 panorama_texel(int x, int y)
{
    int width = picture.behind.y;
    int height = picture.behind.z;
    int column = (y < 0 || y >= height ? x + width / 2 : x) % width;
    uint texel = Words(picture.addresses.zw).words[clamp(y, 0, height - 1) * width + column];
    float scale = uintBitsToFloat(((texel >> 27) + 127u - 24u) << 23);
    return scale * vec3(texel & 511u, (texel >> 9) & 511u, (texel >> 18) & 511u);
}

vec3 panorama_light(vec3 d)
{
    int width = picture.behind.y;
    vec2 place = equirectangular_from_direction(d) * vec2(picture.behind.yz) - 0.5;
    ivec2 at = ivec2(floor(place));
    vec2 share = place - vec2(at);
    int left = (at.x + width) % width;
    vec3 above = mix(panorama_texel(left, at.y), panorama_texel(left + 1, at.y), share.x);
    vec3 below = mix(panorama_texel(left, at.y + 1), panorama_texel(left + 1, at.y + 1), share.x);
    return picture.panorama.x * mix(above, below, share.y);
}

// The lamps that are not in one of the two levels read, through that level's blur.
vec3 lamps_blurred(vec3 d, float share, float variance)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; share > 0.0 && i < picture.fragments.w; ++i) {
        vec3 off = d - lamps[i].direction.xyz;
        sum += (share * gaussian_on_sphere(dot(off, off), variance + lamps[i].direction.w)) * lamps[i].light.xyz;
    }
    return sum;
}

vec3 environment_light(vec2 place)
{
    vec3 d = turned(normalize(picture.direction.xyz + place.x * picture.direction_dx.xyz +
                              place.y * picture.direction_dy.xyz));
    if (picture.behind.x == background_panorama)
        return panorama_light(d);
    return picture.chain.x * textureLod(chain, d, picture.background.w).rgb +
           lamps_blurred(d, picture.blur.x, picture.blur.y) + lamps_blurred(d, picture.blur.z, picture.blur.w);
}

vec3 background_light(vec2 place)
{
    if (picture.behind.x == background_color)
        return picture.background.rgb;
    vec3 light = environment_light(place);
    return picture.panorama.y > 0.0 ? toned_report(report_tone(), light) : light;
}

void main()
{
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(place, picture.tile.zw)))
        return;
    int pixel = place.y * picture.tile.z + place.x;
    int pixels = picture.tile.z * picture.tile.w;
    // Behind more layers than are drawn there is nothing else.
    float share = uintBitsToFloat(spans[pixel].z);
    for (int look = 0; through == 1 && look < looks; ++look)
        share += behind[pixel * looks + look].y;
    if (share <= 0.0 || picture.behind.x == background_none)
        return;
    vec4 light = vec4(share * background_light(vec2(place + picture.tile.xy) + 0.5), 0.0);
    drawn[pixel] += light;
    for (int layer = 0; layer < picture.samples.z; ++layer) // the one that is the background's alone
        if (picture.layers[layer / 4][layer % 4] < 0)
            drawn[(layer + 1) * pixels + pixel] += light;
}
