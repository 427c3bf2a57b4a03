// The hooks of src/shading/README.md on a device. Included after bindings.glsl.

struct Environment {
    int samples;
    int lamps;
};

struct LightSum {
    vec3 first;
    vec3 second;
};

LightSum no_light(Environment e) { return LightSum(vec3(0.0), vec3(0.0)); }

LightSum with_light(Environment e, LightSum sum, vec3 d, float level, vec2 weights)
{
    vec3 light = textureLod(chain, d, level).rgb;
    return LightSum(sum.first + weights.x * light, sum.second + weights.y * light);
}

vec3 first_light(Environment e, LightSum sum) { return picture.chain.x * sum.first; }
vec3 second_light(Environment e, LightSum sum) { return picture.chain.x * sum.second; }
float level_one_variance(Environment e) { return picture.chain.y; }
vec2 lamp_variances(Environment e) { return picture.chain.zw; }
float report_base_level(Environment e) { return picture.maps.y; }
int lamp_count(Environment e) { return e.lamps; }
vec3 lamp_direction(Environment e, int i) { return lamps[i].direction.xyz; }
vec3 lamp_light(Environment e, int i) { return lamps[i].light.xyz; }
int sample_count(Environment e) { return e.samples; }
vec3 cap_point(Environment e, int i) { return samples[i].cap.xyz; }
vec3 lobe_point(Environment e, int i) { return samples[i].lobe.xyz; }
vec2 pixel_point(Environment e, int i) { return vec2(samples[i].cap.w, samples[i].lobe.w); }

// A texel of a level; rows may be one beyond either pole: there the picture goes on across it, which no sampler does.
vec3 mip_texel(int x, int y, ivec2 size, int level)
{
    bool beyond = y < 0 || y >= size.y;
    int turned = beyond ? x + size.x / 2 : x;
    return texelFetch(mips, ivec2((turned + size.x) % size.x, clamp(y, 0, size.y - 1)), level).rgb;
}

vec3 mip_bilinear(vec2 uv, int level)
{
    // Not of the level itself: some drivers give all lanes the size of the first one's.
    ivec2 size = max(textureSize(mips, 0) >> level, ivec2(1));
    vec2 place = uv * vec2(size) - 0.5;
    ivec2 at = ivec2(floor(place));
    vec2 share = place - vec2(at);
    vec3 above = mix(mip_texel(at.x, at.y, size, level), mip_texel(at.x + 1, at.y, size, level), share.x);
    vec3 below = mix(mip_texel(at.x, at.y + 1, size, level), mip_texel(at.x + 1, at.y + 1, size, level), share.x);
    return mix(above, below, share.y);
}

vec3 environment_report_texel(Environment e, vec3 d, float level)
{
    int nearest = int(floor(min(level, float(textureQueryLevels(mips) - 1)) + 0.5));
    ivec2 size = max(textureSize(mips, 0) >> nearest, ivec2(1));
    vec2 place = equirectangular_from_direction(normalize(d)) * vec2(size);
    return texelFetch(mips, clamp(ivec2(place), ivec2(0), size - 1), nearest).rgb;
}

vec3 environment_report_radiance(Environment e, vec3 d, float level)
{
    vec2 uv = equirectangular_from_direction(normalize(d));
    int last = textureQueryLevels(mips) - 1;
    float clamped = min(level, float(last));
    int fine = int(clamped);
    return mix(mip_bilinear(uv, fine), mip_bilinear(uv, min(fine + 1, last)), clamped - float(fine));
}
