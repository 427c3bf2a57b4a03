// The coordinates, the mip level and the number of reads of a texture; backends do the reading. Needs no hooks.

// Texture coordinates, and their changes to the next pixel right and below.
struct TexturePoint {
    vec2 uv;
    vec2 dx;
    vec2 dy;
};

// A pixel's footprint on a texture. level: fractional mip level; ratio: number of reads spread along the axis, 1 to 8;
// longer2: the longer side in texels of level 0, squared.
struct TextureFootprint {
    Real level;
    Real ratio;
    Real longer2;
    vec2 axis;
};

// The shorter side determines the level, and reads are spread along the longer one. If it is more than 8 times as
// long, the level is coarser. [Heckbert 1989, "Fundamentals of texture mapping"; as EXT_texture_filter_anisotropic
// describes it]
// Witness: footprints of 1, 4 and 100 texels by 1, and infinite ones (tests/equations).
TextureFootprint texture_footprint(TexturePoint p, vec2 size, Real last_level)
{
    vec2 dx = vec2(p.dx.x * size.x, p.dx.y * size.y);
    vec2 dy = vec2(p.dy.x * size.x, p.dy.y * size.y);
    Real x2 = dot(dx, dx);
    Real y2 = dot(dy, dy);
    Real longer2 = max(max(x2, y2), 1.0e-12);
    Real shorter2 = max(min(x2, y2), longer2 * 0.015625);
    // Infinite footprints have no ratio, and are read once.
    Real finite = select(longer2 < 1.0e37, longer2, 1.0);
    Real ratio = select(finite > 1.0, sqrt(finite / shorter2), 1.0);
    vec2 axis = vec2(select(x2 > y2, p.dx.x, p.dy.x), select(x2 > y2, p.dx.y, p.dy.y));
    TextureFootprint f = {clamp(0.5 * log2(shorter2), 0.0, last_level), ratio, longer2, axis};
    return f;
}

// A coordinate of a repeated texture, wrapped to [0, 1]. [glTF 2.0, 3.8.4.5] Witness: closed form (tests/equations).
Real repeated(Real x) { return x - floor(x); }

// The same for mirrored repetition. Witness: closed form (tests/equations).
Real repeated_mirrored(Real x)
{
    Real twice = x - 2.0 * floor(0.5 * x);
    return min(twice, 2.0 - twice);
}

// The level read by a sampler that does not blend levels: the nearest, or the finer of two equally near ones.
// [Vulkan 1.3, 16.6.7 "Image Level(s) Selection"] Witness: closed form (tests/equations).
Real nearest_level(Real level) { return -floor(0.5 - level); }

// The centre of the texel at a coordinate, for samplers that read the nearest texel.
// Witness: closed form (tests/equations).
Real snapped(Real x, Real size) { return (floor(x * size) + 0.5) / size; }
