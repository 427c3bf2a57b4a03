#version 460
#extension GL_GOOGLE_include_directive : require
// Sums the light of a pixel's surfaces, and lists the looks that continue behind transparent ones.
#include "draw/vulkan/bindings.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = constant_looks) const int looks = 1;
layout(constant_id = constant_wave) const int wave = 0;
layout(constant_id = constant_through) const int through = 1;

const float least_weight = 1.0 / 1024.0; // the same as in draw/prepared_picture.h

// The opaque share of a surface, 0 to 1.
float shown(uint instance, float opacity)
{
    return materials[instances[instance].ids.y].kind.x == alpha_opaque ? 1.0 : clamp(opacity, 0.0, 1.0);
}

vec3 picture_light(Fragment f)
{
    return load3(f, column_emissive) + load3(f, column_direct) + load3(f, column_ambient) + load3(f, column_reflected);
}

vec3 layer_value(int layer, Fragment f)
{
    int source = picture.layers[layer / 4][layer % 4];
    int column = source >> 2;
    if ((source & 3) == read_three || (source & 3) == read_unlit)
        return load3(f, column);
    float value = load(f, column);
    return vec3((source & 3) == read_root ? sqrt(value) : value);
}

void go_on_behind(FragmentRecord record, uint at, float left)
{
    float unit = length(picture.direction.xyz + record.place.x * picture.direction_dx.xyz +
                        record.place.y * picture.direction_dy.xyz);
    uint look = record.ids.z * uint(looks) + record.ids.w;
    behind[look] = vec4(load(Fragment(at), column_depth) / unit, left, record.place.w, 0.0);
}

// Stores the looks that continue behind the surfaces of the span, and lists the pixel if there are any.
void look_behind(uint pixel, uvec4 span)
{
    bool goes_on = false;
    for (int look = 0; look < looks; ++look)
        behind[pixel * uint(looks) + uint(look)] = vec4(0.0);
    for (uint at = span.x; at < span.x + span.y; ++at) {
        FragmentRecord record = records[at];
        float left = record.place.z * (1.0 - shown(record.ids.x, load(Fragment(at), column_opacity)));
        if (left >= least_weight) {
            go_on_behind(record, at, left);
            goes_on = true;
        }
    }
    spans[pixel].y = 0u; // these are summed; the next wave may find more
    if (goes_on)
        listed[add_listed(1u)] = pixel;
}

// The sum of a pixel's surfaces in a layer, or in the picture (layer -1).
vec4 drawn_light(int layer, uvec4 span)
{
    vec4 sum = vec4(0.0);
    for (uint at = span.x; at < span.x + span.y; ++at) {
        FragmentRecord record = records[at];
        float weight = record.place.z;
        if (through == 1)
            weight *= shown(record.ids.x, load(Fragment(at), column_opacity));
        if (layer >= 0 && (picture.layers[layer / 4][layer % 4] & 3) == read_unlit && load(Fragment(at), column_lit) > 0.0)
            continue;
        if (weight > 0.0)
            sum += weight * vec4(layer < 0 ? picture_light(Fragment(at)) : layer_value(layer, Fragment(at)), 1.0);
    }
    return sum;
}

void main()
{
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(place, picture.tile.zw)))
        return;
    int pixel = place.y * picture.tile.z + place.x;
    int pixels = picture.tile.z * picture.tile.w;
    uvec4 span = spans[pixel];
    for (int layer = -1; layer < picture.samples.z; ++layer) {
        bool empty = layer >= 0 && picture.layers[layer / 4][layer % 4] < 0;
        vec4 sum = empty ? vec4(0.0) : drawn_light(layer, span);
        if (wave > 0)
            sum += drawn[(layer + 1) * pixels + pixel];
        drawn[(layer + 1) * pixels + pixel] = sum;
    }
    if (through == 1)
        look_behind(uint(pixel), span);
}
