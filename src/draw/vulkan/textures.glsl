// Reading packed textures. Included after geometry.glsl.

// A texel as linear values, from 8-bit codes or half floats.
vec4 texel_of(TextureRecord t, uint texel)
{
    Words words = Words(t.place.xy);
    if (t.place.z == 1u)
        return vec4(unpackHalf2x16(words.words[2u * texel]), unpackHalf2x16(words.words[2u * texel + 1u]));
    uint codes = words.words[texel];
    uint table = 256u * t.place.w;
    return vec4(code_light[table + (codes & 255u)], code_light[table + ((codes >> 8) & 255u)],
                code_light[table + ((codes >> 16) & 255u)], float(codes >> 24) / 255.0);
}

// The bilinear value in a level. A border of one texel makes all neighbours adjacent in memory.
vec4 level_at(TextureRecord t, vec2 uv, int level)
{
    ivec4 shape = t.levels[level];
    vec2 place = uv * vec2(shape.xy) + 0.5;
    ivec2 at = min(ivec2(place), shape.xy);
    vec2 share = place - vec2(at);
    uint pitch = uint(shape.x) + 2u;
    uint texel = uint(shape.z) + uint(at.y) * pitch + uint(at.x);
    return mix(mix(texel_of(t, texel), texel_of(t, texel + 1u), share.x),
               mix(texel_of(t, texel + pitch), texel_of(t, texel + pitch + 1u), share.x), share.y);
}

float wrapped(float x, int wrap)
{
    if (wrap == wrap_repeat)
        return repeated(x);
    return wrap == wrap_clamp ? clamp(x, 0.0, 1.0) : repeated_mirrored(x);
}

// Coordinates in a level, snapped to the centre of the nearest texel if `nearest` is set, and wrapped to [0, 1].
vec2 placed(TextureRecord t, vec2 uv, int level, bool nearest)
{
    if (nearest)
        uv = vec2(snapped(uv.x, float(t.levels[level].x)), snapped(uv.y, float(t.levels[level].y)));
    return vec2(wrapped(uv.x, t.reading.x), wrapped(uv.y, t.reading.y));
}

// The alpha test of a mask: a texel is opaque where alpha * vertex * factor >= cutoff.
struct MaskCut {
    bool used;
    float vertex;
    float factor;
    float cutoff;
};

float there(MaskCut mask, float alpha) { return alpha * mask.vertex * mask.factor >= mask.cutoff ? 1.0 : 0.0; }

// Alpha of the finest level is tested against the cutoff. Coarser levels hold the opaque share, which counts where a
// texel with alpha 1 would pass.
vec4 masked_level_at(TextureRecord t, vec2 uv, int level, MaskCut mask)
{
    vec4 texel = level_at(t, uv, level);
    if (mask.used)
        texel.a = level == 0 ? there(mask, texel.a) : texel.a * there(mask, 1.0);
    return texel;
}

// Reads a texture, filtered over the pixel's footprint. For masks, alpha is the opaque share.
vec4 read_texture(int index, TexturePoint p, MaskCut mask)
{
    TextureRecord t = textures[index];
    vec2 size = vec2(t.levels[0].xy);
    TextureFootprint f = texture_footprint(p, size, float(t.reading.w - 1));
    int reads = t.reading.w > 1 ? int(ceil(f.ratio - 0.01)) : 1;
    float level = (t.reading.z & filter_nearest_mipmap) != 0 ? nearest_level(f.level) : f.level;
    bool nearest = (t.reading.z & (f.longer2 < 1.0 ? filter_magnify_nearest : filter_minify_nearest)) != 0;
    int fine = int(level);
    float coarser = level - float(fine);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < reads; ++i) {
        vec2 uv = p.uv + ((float(i) + 0.5) / float(reads) - 0.5) * f.axis;
        sum += (1.0 - coarser) * masked_level_at(t, placed(t, uv, fine, nearest), fine, mask);
        if (coarser > 0.0)
            sum += coarser * masked_level_at(t, placed(t, uv, fine + 1, nearest), fine + 1, mask);
    }
    return sum / float(reads);
}
