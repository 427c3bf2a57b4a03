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
    const vec3 believed = vec3(select(light.x > 0.0, min(light.x, 1.0e30), 0.0),
                               select(light.y > 0.0, min(light.y, 1.0e30), 0.0),
                               select(light.z > 0.0, min(light.z, 1.0e30), 0.0));
    const vec3 exposed = min(Real(s.exposure) * believed, vec3(1.0e30));
    const vec3 toned = clamp(curve(s.tone, exposed), 0.0, 1.0);
    const bool by_power = s.tone == Tone::reinhard || s.tone == Tone::agx;
    const float exponent = s.encode && by_power ? s.contrast / 2.2f : s.contrast;
    const vec3 contrasted = exponent == 1.0f ? toned : power(toned, Real(exponent));
    return s.encode && !by_power ? srgb_encode(contrasted) : contrasted;
}

// Noise in (-1, 1) with a triangular distribution: the sum of two hashes of the place. [Wang 2007, integer hash]
Real triangular_noise(Int x, int y, int channel)
{
    const auto hash = [](Int seed) HWY_ATTR {
        const Int a = hn::Mul(hn::Xor(seed, hn::ShiftRight<15>(seed)), integer(0x2c1b3c6d));
        const Int b = hn::Mul(hn::Xor(a, hn::ShiftRight<12>(a)), integer(0x297a2d39));
        return hn::And(hn::Xor(b, hn::ShiftRight<15>(b)), integer(0xffff));
    };
    // In unsigned numbers, which may overflow.
    const uint32_t row = static_cast<uint32_t>(y) * 0x1f123u + static_cast<uint32_t>(channel) * 0x5851u;
    const Int place = hn::Add(x, integer(static_cast<int>(row)));
    const Int other = hn::Add(place, integer(0x3ade68b));
    return to_real(hn::Sub(hash(place), hash(other))) * (1.0 / 65536.0);
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
        alignas(64) float planes[3][max_lanes] = {};
        const float* in = row.light + static_cast<ptrdiff_t>(first) * row.channels;
        for (int i = 0; i < count; ++i)
            for (int c = 0; c < 3; ++c)
                planes[c][i] = in[i * row.channels + c];
        const vec3 shown = displayed(settings, vec3(load(planes[0]), load(planes[1]), load(planes[2])));
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
