// Reading PackedTextures with lanes of coordinates. Included after wide/wide.h and shading/points.glsl, inside the
// target's namespace: no guard. Addresses are computed per lane in scalar code; the compiler vectorises the sums by
// eight: two RGBA texels.

// A coordinate mapped to [0, 1] by the sampler's wrap mode.
HWY_INLINE Real wrapped(Real x, scene::Wrap wrap)
{
    if (wrap == scene::Wrap::repeat)
        return repeated(x);
    return wrap == scene::Wrap::clamp_to_edge ? clamp(x, 0.0, 1.0) : repeated_mirrored(x);
}

// Adds two neighbouring texels times their weights to eight sums (r g b a of the left, then of the right one).
HWY_INLINE void add_pair(const PackedTexture& t, size_t texel, float left, float right, float* sums)
{
    const float weights[8] = {left, left, left, left, right, right, right, right};
    float values[8];
    if (t.half_floats) {
        const auto* halfs = reinterpret_cast<const uint16_t*>(t.bytes.data()) + 4 * texel;
        for (int i = 0; i < 8; ++i) {
            const uint32_t moved = static_cast<uint32_t>(halfs[i]) << 13;
            memcpy(&values[i], &moved, sizeof moved);
            values[i] *= 0x1p112f;
        }
    } else {
        const uint8_t* codes = t.bytes.data() + 4 * texel;
        for (int i = 0; i < 8; ++i)
            values[i] = (i % 4 == 3 ? t.alpha : t.light)[codes[i]];
    }
    for (int i = 0; i < 8; ++i)
        sums[i] += weights[i] * values[i];
}

// One bilinear read: level, coordinates in [0, 1], weight.
struct TextureRead {
    int level;
    float u, v;
    float weight;
};

// Adds the bilinear value times its weight to the sums of add_pair.
HWY_INLINE void add_bilinear(const PackedTexture& t, TextureRead read, float* sums)
{
    const int level = read.level, width = t.width[level], height = t.height[level];
    const float x = read.u * static_cast<float>(width) + 0.5f, y = read.v * static_cast<float>(height) + 0.5f;
    // 0.5 = 1 (the border) - 0.5 (the centre of a texel). A coordinate of 1 may round up.
    const int x0 = x < static_cast<float>(width) ? static_cast<int>(x) : width;
    const int y0 = y < static_cast<float>(height) ? static_cast<int>(y) : height;
    const float right = x - static_cast<float>(x0), below = y - static_cast<float>(y0);
    const size_t pitch = static_cast<size_t>(width) + 2;
    const size_t texel =
        static_cast<size_t>(t.start[level]) + static_cast<size_t>(y0) * pitch + static_cast<size_t>(x0);
    const float upper = read.weight * (1.0f - below), lower = read.weight * below;
    add_pair(t, texel, upper * (1.0f - right), upper * right, sums);
    add_pair(t, texel + pitch, lower * (1.0f - right), lower * right, sums);
}

// The reads of all lanes between two levels: coordinates in the finer and, where they differ, in the coarser level.
struct TextureReads {
    alignas(64) float u[2][max_lanes];
    alignas(64) float v[2][max_lanes];
    alignas(64) float level[max_lanes];
    int coarser = 0; // index of the coordinates in the coarser level
};

// The size of a level that may differ between lanes.
HWY_INLINE vec2 level_size(const PackedTexture& t, Real level)
{
    const Int index = truncated(min(level, t.levels - 1));
    return vec2(to_real(hn::GatherIndex(IntTag(), t.width, index)),
                to_real(hn::GatherIndex(IntTag(), t.height, index)));
}

// Coordinates in a level, snapped to the centre of the nearest texel where `nearest` is set.
HWY_INLINE vec2 placed(const PackedTexture& t, vec2 uv, Real level, Mask nearest)
{
    const vec2 size = level_size(t, level);
    return vec2(select(nearest, snapped(uv.x, size.x), uv.x), select(nearest, snapped(uv.y, size.y), uv.y));
}

HWY_INLINE void store_place(const PackedTexture& t, vec2 uv, int which, TextureReads& reads)
{
    store(wrapped(uv.x, t.sampler.wrap_u), reads.u[which]);
    store(wrapped(uv.y, t.sampler.wrap_v), reads.v[which]);
}

// The alpha test of a mask: a texel is opaque where alpha * vertex * factor >= cutoff.
struct MaskCut {
    alignas(64) float vertex[max_lanes];
    float factor, cutoff;

    float there(float alpha, size_t lane) const
    {
        return alpha * vertex[lane] * factor >= cutoff ? 1.0f : 0.0f;
    }
};

// Alpha of the finest level is tested against the cutoff. Coarser levels hold the opaque share, which counts where a
// texel with alpha 1 would pass.
HWY_INLINE void add_masked(const PackedTexture& t, TextureRead read, const MaskCut& mask, size_t lane,
                           float* sums)
{
    float own[8] = {};
    add_bilinear(t, {read.level, read.u, read.v, 1.0f}, own);
    const float alpha = own[3] + own[7], most = mask.there(1.0f, lane);
    own[3] = read.level == 0 ? mask.there(alpha, lane) : alpha * most;
    own[7] = 0.0f;
    for (size_t i = 0; i < 8; ++i)
        sums[i] += read.weight * own[i];
}

HWY_INLINE void add_reads(const PackedTexture& t, const TextureReads& reads, float weight,
                          const MaskCut* mask, float* rgba_per_lane)
{
    for (size_t lane = 0; lane < lane_count; ++lane) {
        float sums[8] = {};
        const int fine = static_cast<int>(reads.level[lane]);
        const float fraction = reads.level[lane] - static_cast<float>(fine);
        const int next = reads.coarser;
        const auto add = [&](TextureRead read) HWY_ATTR {
            if (mask)
                add_masked(t, read, *mask, lane, sums);
            else
                add_bilinear(t, read, sums);
        };
        add({fine, reads.u[0][lane], reads.v[0][lane], weight * (1.0f - fraction)});
        if (fraction > 0.0f)
            add({fine + 1, reads.u[next][lane], reads.v[next][lane], weight * fraction});
        for (size_t i = 0; i < 4; ++i)
            rgba_per_lane[4 * lane + i] += sums[i] + sums[i + 4];
    }
}

// Reads a texture, filtered over the pixel's footprint. For masks, alpha is the opaque share. Samplers of nearest
// texels get one texel of each level for each of the reads that make up the footprint.
ONE_BODY Texel read_texture(const PackedTexture& t, TexturePoint p, const MaskCut* mask = nullptr)
{
    const scene::Sampler& sampler = t.sampler;
    const TextureFootprint footprint = texture_footprint(p, vec2(t.width[0], t.height[0]), t.levels - 1);
    const int reads = t.levels > 1 ? static_cast<int>(ceil(largest_lane(footprint.ratio) - 0.01f)) : 1;
    // A lane that needs fewer reads than its neighbours has them closer together.
    const Real step = 1.0 / Real(reads);
    alignas(64) float rgba[4 * max_lanes] = {};
    const Real level = sampler.nearest_mipmap ? nearest_level(footprint.level) : footprint.level;
    const bool any_nearest = sampler.magnify_nearest || sampler.minify_nearest;
    const Mask nearest = select(footprint.longer2 < 1.0, Real(sampler.magnify_nearest ? 1.0 : 0.0),
                                Real(sampler.minify_nearest ? 1.0 : 0.0)) > 0.5;
    TextureReads where;
    where.coarser = any_nearest ? 1 : 0;
    store(level, where.level);
    for (int i = 0; i < reads; ++i) {
        const Real offset = (Real(i) + 0.5) * step - 0.5;
        const vec2 uv = p.uv + offset * footprint.axis;
        store_place(t, any_nearest ? placed(t, uv, level, nearest) : uv, 0, where);
        if (any_nearest)
            store_place(t, placed(t, uv, level + 1.0, nearest), 1, where);
        add_reads(t, where, 1.0f / static_cast<float>(reads), mask, rgba);
    }
    Texel c{0.0, 0.0, 0.0, 0.0};
    hn::LoadInterleaved4(FloatTag(), rgba, c.r.v, c.g.v, c.b.v, c.a.v);
    return c;
}
