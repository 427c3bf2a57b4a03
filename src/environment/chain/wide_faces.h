// Rows of a cube's faces on SIMD lanes. Included after wide/wide.h, inside a namespace of each target: no guard.

// Rounds a number from 0 to 65504 to the nearest half, ties to even. Highway's own conversion truncates where the
// processor has none (SSE4 and portable), which would darken all light by half a step on average.
Real nearest_half(Real a)
{
    const Int odd = hn::And(hn::ShiftRight<13>(bits(a)), integer(1));
    const Int up = hn::Add(hn::Add(bits(a), integer(0xfff)), odd);
    const Real normal = from_bits(hn::And(up, integer(~0x1fff)));
    // Halfs below 2^-14 have one step size, that of the floats from 0.5 to 1.
    return select(a < 0x1p-14, (a + 0.5) - 0.5, normal);
}

// Clamps to the range of halfs and stores the first `count` lanes as texels.
void store_halfs(vec3 rgb, size_t count, uint16_t* halfs)
{
    const hn::Rebind<hwy::float16_t, FloatTag> half_tag;
    alignas(64) float interleaved[3 * max_lanes];
    alignas(64) uint16_t rounded[3 * max_lanes];
    const vec3 cut = clamp(rgb, 0.0, 65504.0);
    hn::StoreInterleaved3(nearest_half(cut.x).v, nearest_half(cut.y).v, nearest_half(cut.z).v, FloatTag(),
                          interleaved);
    for (size_t i = 0; i < 3; ++i) {
        const auto values = hn::Load(FloatTag(), interleaved + i * lane_count);
        hn::Store(hn::DemoteTo(half_tag, values), half_tag,
                  reinterpret_cast<hwy::float16_t*>(rounded) + i * lane_count);
    }
    for (size_t i = 0; i < 3 * count; ++i)
        halfs[i] = rounded[i];
}

// The coordinates, in [-1, 1], of the points at the fraction `inside` (0 to 1) of the texels first, first + 1, ...
Real face_coordinate(int first, float inside, int size)
{
    const Real x = Real(hn::Iota(FloatTag(), static_cast<float>(first))) + Real(inside);
    return x * Real(2.0f / static_cast<float>(size)) - 1.0;
}

size_t lanes_left(int x, int size)
{
    return std::min(lane_count, static_cast<size_t>(size - x));
}
