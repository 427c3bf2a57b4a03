#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/display_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "display/display_kernel.h"

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace lambent::display::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"

vec3 curve(Tone tone, vec3 c)
{
    switch (tone) {
    case Tone::reinhard:
        return tone_reinhard(c);
    case Tone::neutral:
        return tone_neutral(c);
    case Tone::aces:
        return tone_aces(c);
    case Tone::agx:
        return tone_agx(c);
    case Tone::linear:
        break;
    }
    return tone_linear(c);
}

// Code values in [0, 1].
vec3 displayed(const Settings& s, vec3 light)
{
    // Beyond 1e30 every curve is white; NaN compares false and becomes black.
    const vec3 valid = vec3(select(light.x > 0.0, min(light.x, 1.0e30), 0.0),
                            select(light.y > 0.0, min(light.y, 1.0e30), 0.0),
                            select(light.z > 0.0, min(light.z, 1.0e30), 0.0));
    const vec3 exposed = min(Real(s.exposure) * valid, vec3(1.0e30));
    const vec3 toned = clamp(curve(s.tone, exposed), 0.0, 1.0);
    const bool by_power = s.tone == Tone::reinhard || s.tone == Tone::agx;
    const float exponent = s.encode && by_power ? s.contrast / 2.2f : s.contrast;
    const vec3 contrasted = exponent == 1.0f ? toned : power(toned, Real(exponent));
    return s.encode && !by_power ? srgb_encode(contrasted) : contrasted;
}

// The light that a display emits for a code; code_of_light() is the inverse.
vec3 light_of_code(const Settings& s, vec3 code)
{
    if (!s.encode)
        return code;
    return s.unlit_by_power ? power(code, Real(2.2))
                            : vec3(srgb_decode(code.x), srgb_decode(code.y), srgb_decode(code.z));
}

vec3 code_of_light(const Settings& s, vec3 light)
{
    if (!s.encode)
        return light;
    return s.unlit_by_power ? power(light, Real(1.0 / 2.2)) : srgb_encode(light);
}

// Code values of light that contains `unlit`, a colour without lighting that covers `share` of the pixel.
vec3 displayed_with(const Settings& s, vec3 light, vec3 unlit, Real share)
{
    constexpr double least = 1.0 / 512.0; // share of lit light; less is a rounding error
    const Real part = clamp(share, 0.0, 1.0), left = 1.0 - part;
    const Real scale = select(left > least, 1.0 / max(left, least), 0.0);
    const vec3 rest = displayed(s, scale * (light - unlit));
    const vec3 own(min(max(unlit.x, 0.0), part), min(max(unlit.y, 0.0), part), min(max(unlit.z, 0.0), part));
    const vec3 mixed = code_of_light(s, clamp(left * light_of_code(s, rest) + own, 0.0, 1.0));
    return select(part > 0.0, mixed, displayed(s, light));
}

// Loads the first `used` of each pixel's `channels` values, one plane per value. Lanes from `count` on are left as they
// are.
void load_planes(const float* in, int channels, int count, float (*planes)[max_lanes], int used)
{
    for (int i = 0; i < count; ++i)
        for (int c = 0; c < used; ++c)
            planes[c][i] = in[i * channels + c];
}

vec3 shown_at(const DisplayRow& row, const Settings& settings, int first, int count)
{
    alignas(64) float planes[3][max_lanes] = {};
    load_planes(row.light + static_cast<ptrdiff_t>(first) * row.channels, row.channels, count, planes, 3);
    const vec3 light(load(planes[0]), load(planes[1]), load(planes[2]));
    if (!row.unlit)
        return displayed(settings, light);
    alignas(64) float own[4][max_lanes] = {};
    load_planes(row.unlit + 4 * static_cast<ptrdiff_t>(first), 4, count, own, 4);
    return displayed_with(settings, light, vec3(load(own[0]), load(own[1]), load(own[2])), load(own[3]));
}

// Noise in (-1, 1) with a triangular distribution: the difference of two hashes of the pixel's coordinates and channel.
// [Wang 2007, integer hash]
Real triangular_noise(Int x, int y, int channel)
{
    const auto hash = [](Int seed) HWY_ATTR {
        const Int a = hn::Mul(hn::Xor(seed, hn::ShiftRight<15>(seed)), integer(0x2c1b3c6d));
        const Int b = hn::Mul(hn::Xor(a, hn::ShiftRight<12>(a)), integer(0x297a2d39));
        return hn::And(hn::Xor(b, hn::ShiftRight<15>(b)), integer(0xffff));
    };
    // Unsigned, since overflow is intended.
    const uint32_t row = static_cast<uint32_t>(y) * 0x1f123u + static_cast<uint32_t>(channel) * 0x5851u;
    const Int seed = hn::Add(x, integer(static_cast<int>(row)));
    const Int other = hn::Add(seed, integer(0x3ade68b));
    return to_real(hn::Sub(hash(seed), hash(other))) * (1.0 / 65536.0);
}

Int rounded(const Settings& s, Real value, Int x, int y, int channel)
{
    Real code = 255.0 * value;
    if (s.dither)
        code = clamp(code + triangular_noise(x, y, channel), 0.0, 255.0);
    return truncated(code + 0.5);
}

} // namespace

HWY_FLATTEN void display_row(const DisplayRow& row, const Settings& settings, uint8_t* codes)
{
    const int lanes = static_cast<int>(lane_count);
    for (int first = 0; first < row.count; first += lanes) {
        const int count = std::min(lanes, row.count - first);
        const vec3 shown = shown_at(row, settings, first, count);
        const Int x = hn::Iota(IntTag(), first);
        const Real values[3] = {shown.x, shown.y, shown.z};
        for (int c = 0; c < 3; ++c) {
            alignas(64) int32_t whole[max_lanes];
            hn::Store(rounded(settings, values[c], x, row.y, c), IntTag(), whole);
            for (int i = 0; i < count; ++i)
                codes[3 * (first + i) + c] = static_cast<uint8_t>(whole[i]);
        }
    }
}

} // namespace lambent::display::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::display {

HWY_EXPORT(display_row);

void display_row(const DisplayRow& row, const Settings& settings, std::uint8_t* codes)
{
    HWY_DYNAMIC_DISPATCH(display_row)(row, settings, codes);
}

} // namespace lambent::display
#endif
