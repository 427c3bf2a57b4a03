// How alike two pixels are, over lanes. Included inside the target's namespace, after wide.h: no guard, by design.

constexpr double surface_power = 32.0; // of the cosine between normals, where lobes do not count

// The guides of one vector of pixels.
struct GuidesAt {
    Real normal_x, normal_y, normal_z, depth, slope_x, slope_y, roughness, metalness;
};

HWY_INLINE GuidesAt guides_at(const float* at, ptrdiff_t pitch)
{
    return {load(at),
            load(at + pitch),
            load(at + 2 * pitch),
            load(at + depth_plane * pitch),
            load(at + slope_x_plane * pitch),
            load(at + slope_y_plane * pitch),
            load(at + roughness_plane * pitch),
            load(at + metalness_plane * pitch)};
}

// 2^-a for whole a >= 0, linear in between: at most 6 % more than 2^-a. From a = 20 on it is 0, so that nothing leaks, and no
// number becomes denormal, which is slow. The number's exponent is where floats have theirs, so its fraction becomes a
// mantissa.
HWY_INLINE Real half_to_the(Real a)
{
    constexpr double one = 1 << 23; // of the exponent
    const Real place = (127.0 - a) * one;
    return from_bits(truncated(select(a < 20.0, place, 0.0)));
}

// A weight in [0, 1] for pixels that lie (dx, dy) apart. It falls with the angle between the normals as the cosine to
// `power` does near 1; with the distance from each other's planes, against .4 % of the depth and half of the slope
// between them; and with the difference of materials, against .03. Symmetric but for `power`.
HWY_INLINE Real likeness(const GuidesAt& p, const GuidesAt& q, Real power, float dx, float dy)
{
    constexpr double log2_e = 1.4426950408889634;
    const Real nx = p.normal_x - q.normal_x, ny = p.normal_y - q.normal_y, nz = p.normal_z - q.normal_z;
    const Real angle = nx * nx + ny * ny + nz * nz; // 2 - 2 cos
    const Real slope = (0.5f * dx) * (p.slope_x + q.slope_x) + (0.5f * dy) * (p.slope_y + q.slope_y);
    const Real distance = abs(q.depth - p.depth - slope);
    const Real tolerance = 0.002 * (p.depth + q.depth) + 0.5 * abs(slope) + 1.0e-12;
    const Real material = abs(p.roughness - q.roughness) + abs(p.metalness - q.metalness);
    return half_to_the(log2_e * (distance / tolerance) + (0.5 * log2_e) * power * angle +
                       (log2_e / 0.03) * material);
}
