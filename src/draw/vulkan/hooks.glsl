// The hooks of src/shading/README.md on a device. Included after bindings.glsl.

struct Environment {
    int samples;
    int first_sample;
    int lamps;
};

int has_stretch() { return 0; } // materials have no anisotropy

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
float lamp_variance(Environment e, int i) { return lamps[i].direction.w; }
vec2 lamp_variances(Environment e) { return picture.chain.zw; }
float report_base_level(Environment e) { return picture.maps.y; }
int lamp_count(Environment e) { return e.lamps; }
vec3 lamp_direction(Environment e, int i) { return lamps[i].direction.xyz; }
vec3 lamp_light(Environment e, int i) { return lamps[i].light.xyz; }
int sample_count(Environment e) { return e.samples; }
vec3 cap_point(Environment e, int i) { return samples[e.first_sample + i].cap.xyz; }
vec3 lobe_point(Environment e, int i) { return samples[e.first_sample + i].lobe.xyz; }
vec2 pixel_point(Environment e, int i) { return vec2(samples[e.first_sample + i].cap.w, samples[e.first_sample + i].lobe.w); }

float highest_level(Environment e) { return float(textureQueryLevels(chain) - 1); }
float highest_report_level(Environment e) { return float(textureQueryLevels(mips) - 1); }
vec3 across_of(Environment e) { return picture.across.xyz; }
float compensation_of(Environment e) { return picture.rotation.w; }
float ambient_brightness(Environment e) { return picture.rotation.z; }
ReportTone report_tone(Environment e) { return ReportTone(picture.report.x, picture.report.y, picture.report.z, picture.report.w); }

// A world direction in the environment's own frame.
vec3 turned(Environment e, vec3 d)
{
    float c = picture.rotation.x;
    float s = picture.rotation.y;
    return vec3(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}

vec3 in_world(Environment e, vec3 d)
{
    float c = picture.rotation.x;
    float s = picture.rotation.y;
    return vec3(c * d.x + s * d.z, d.y, c * d.z - s * d.x);
}

vec3 environment_irradiance(Environment e, vec3 d) { return picture.maps.x * textureLod(irradiance_map, d, 0.0).rgb; }

int background_of(Environment e) { return picture.behind.x; }

// A texel of the panorama before scaling; rows beyond a pole continue on its other side.
vec3 panorama_texel(int x, int y)
{
    int width = picture.behind.y;
    int height = picture.behind.z;
    int column = (y < 0 || y >= height ? x + width / 2 : x) % width;
    uint texel = Words(picture.addresses.zw).words[clamp(y, 0, height - 1) * width + column];
    float scale = uintBitsToFloat(((texel >> 27) + 127u - 24u) << 23);
    return scale * vec3(texel & 511u, (texel >> 9) & 511u, (texel >> 18) & 511u);
}

vec3 environment_panorama(Environment e, vec3 d)
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

vec3 environment_blurred(Environment e, vec3 d) { return picture.chain.x * textureLod(chain, d, picture.background.w).rgb; }
float share_of_level(Environment e, int level) { return picture.blur[2 * level]; }
float variance_of_level(Environment e, int level) { return picture.blur[2 * level + 1]; }
int is_without_lamps(Environment e, int level) { return share_of_level(e, level) > 0.0 ? 1 : 0; }

// A texel of a mip level. A row beyond a pole continues on its other side, which samplers cannot do.
vec3 mip_texel(int x, int y, ivec2 size, int level)
{
    bool beyond = y < 0 || y >= size.y;
    int turned = beyond ? x + size.x / 2 : x;
    return texelFetch(mips, ivec2((turned + size.x) % size.x, clamp(y, 0, size.y - 1)), level).rgb;
}

vec3 mip_bilinear(vec2 uv, int level)
{
    // Computed from level 0: if the level differs between lanes, some drivers return the size for the first lane only.
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
