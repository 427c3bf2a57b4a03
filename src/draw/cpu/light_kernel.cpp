#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "draw/cpu/light_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "albedo/albedo_table.h"
#include "draw/cpu/light_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent::draw::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "draw/cpu/wide_fragments.h"
#include "environment/chain/wide_cube.h"
#include "environment/panorama/wide_panorama.h"

#include "shading/numbers.glsl"

#include "draw/cpu/wide_environment.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // those of the surface pass
#pragma GCC diagnostic ignored "-Wunused-parameter" // in code made from empty lists
#include "shading/all.glsl"
#include "shading/light_passes.glsl"
#pragma GCC diagnostic pop

Arrival arrival_at(const LightSource& light, vec3 point)
{
    return arrival_of({uniform(light.position), uniform(light.intensity), uniform(light.axis),
                       1.0f / light.range, light.cos_inner, light.cos_outer},
                      light.local, point);
}

// Sets the level of the background, and weight and variance of those of the two levels around it that lack the lamps.
void place_background(const environment::Environment& from, float level, Environment& e)
{
    e.background_level = level;
    const float clamped = std::min(level, static_cast<float>(e.levels - 1)), fine = std::floor(clamped);
    const float shares[] = {1.0f - (clamped - fine), clamped - fine};
    for (int i = 0; i < 2; ++i) {
        const int whole = static_cast<int>(fine) + i;
        e.level_shares[i] = level >= 0.0f && whole > e.lamps->last_level ? shares[i] : 0.0f;
        e.level_variances[i] =
            e.level_shares[i] > 0.0f ? environment::level_variance(from.chain, whole) : 0.0f;
    }
}

} // namespace

HWY_FLATTEN void light_directly(const LightContext& context, std::span<const LightSource> lights,
                                size_t begin, size_t end, Fragments& fragments)
{
    const Environment e = environment_of(context, nullptr);
    for (size_t at = begin; at < end; at += lane_count) {
        const Fragment f = fragment(fragments, at);
        const Receiver receiver = receiver_at(e, f);
        vec3 sum(0.0);
        for (const LightSource& light : lights)
            sum += direct_light(e, receiver, arrival_at(light, receiver.point));
        store3(f, column_direct, sum);
    }
}

HWY_FLATTEN void light_ambiently(const LightContext& context, size_t begin, size_t end, Fragments& fragments)
{
    const Environment e = environment_of(context, nullptr);
    for (size_t at = begin; at < end; at += lane_count)
        add_ambient(e, fragment(fragments, at));
}

HWY_FLATTEN void light_background(const LightContext& context, const RayMap& rays, const BackgroundRow& row,
                                  float* const rgb[3])
{
    Environment e = environment_of(context, nullptr);
    place_background(*context.environment, row.level, e);
    const vec3 start = uniform(rays.direction) + Real(row.y) * uniform(rays.direction_dy);
    for (int x = 0; x < row.count; x += static_cast<int>(lane_count)) {
        const Real place = Real(hn::Iota(FloatTag(), static_cast<float>(row.first_x + x))) + 0.5;
        const vec3 c = background_light(e, normalize(start + place * uniform(rays.direction_dx)));
        store(c.x, rgb[0] + x);
        store(c.y, rgb[1] + x);
        store(c.z, rgb[2] + x);
    }
}

} // namespace lambent::draw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::draw {

HWY_EXPORT(light_directly);
HWY_EXPORT(light_ambiently);
HWY_EXPORT(light_background);

void light_directly(const LightContext& context, std::span<const LightSource> lights, std::size_t begin,
                    std::size_t end, Fragments& fragments)
{
    HWY_DYNAMIC_DISPATCH(light_directly)(context, lights, begin, end, fragments);
}

void light_ambiently(const LightContext& context, std::size_t begin, std::size_t end, Fragments& fragments)
{
    HWY_DYNAMIC_DISPATCH(light_ambiently)(context, begin, end, fragments);
}

void light_background(const LightContext& context, const RayMap& rays, const BackgroundRow& row,
                      float* const rgb[3])
{
    HWY_DYNAMIC_DISPATCH(light_background)(context, rays, row, rgb);
}

} // namespace lambent::draw
#endif
