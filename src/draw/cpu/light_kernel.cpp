#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "draw/cpu/light_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "draw/cpu/light_kernel.h"
#include "albedo/albedo_table.h"

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

// What the hooks of src/shading/README.md read.
struct Environment {
    CubeSums* sums;
    float scale;    // of the chain
    float variance; // of its level 1
    int levels;     // of the chain
    const environment::Lamps* lamps;
    float lamp_variances[2];
    const environment::Panorama* mips;
    int mip_levels;
    const SampleTables* tables;
    int samples;
};

HWY_INLINE int sample_count(const Environment& e)
{
    return e.samples;
}

HWY_INLINE vec3 cap_point(const Environment& e, int i)
{
    const SampleTables::Cap& p = e.tables->cap[static_cast<size_t>(i)];
    return vec3(p.xi2, p.cosine, p.sine);
}

HWY_INLINE vec3 lobe_point(const Environment& e, int i)
{
    const SampleTables::Lobe& p = e.tables->lobe[static_cast<size_t>(i)];
    return vec3(p.log2_xi2, p.cosine, p.sine);
}

HWY_INLINE vec2 pixel_point(const Environment& e, int i)
{
    const SampleTables::Pixel& p = e.tables->pixel[static_cast<size_t>(i)];
    return vec2(p.x, p.y);
}

HWY_INLINE Real level_one_variance(const Environment& e)
{
    return e.variance;
}

HWY_INLINE int lamp_count(const Environment& e)
{
    return static_cast<int>(e.lamps->lamps.size());
}

HWY_INLINE vec3 lamp_direction(const Environment& e, int i)
{
    const float* d = e.lamps->lamps[static_cast<size_t>(i)].direction;
    return vec3(d[0], d[1], d[2]);
}

HWY_INLINE vec3 lamp_light(const Environment& e, int i)
{
    const float* light = e.lamps->lamps[static_cast<size_t>(i)].light;
    return vec3(light[0], light[1], light[2]);
}

HWY_INLINE vec2 lamp_variances(const Environment& e)
{
    return vec2(e.lamp_variances[0], e.lamp_variances[1]);
}

// The sums live in the environment; the text hands this around.
struct LightSum {};

HWY_INLINE LightSum no_light(const Environment& e)
{
    e.sums->clear();
    return {};
}

HWY_INLINE LightSum with_light(const Environment& e, LightSum, vec3 d, Real level, vec2 weights)
{
    e.sums->add(d, level, weights.x, weights.y);
    return {};
}

HWY_INLINE vec3 first_light(const Environment& e, LightSum)
{
    return Real(e.scale) * e.sums->first();
}
HWY_INLINE vec3 second_light(const Environment& e, LightSum)
{
    return Real(e.scale) * e.sums->second();
}

HWY_INLINE Real report_base_level(const Environment& e)
{
    // NOLINTNEXTLINE(clang-analyzer-core.NullDereference): asked for only when the report's levels were made
    return 0.5f * std::log2(static_cast<float>(e.mips[0].width) * static_cast<float>(e.mips[0].height));
}

PanoramaView view(const environment::Panorama& p)
{
    return {reinterpret_cast<const int32_t*>(p.texels.data()), p.width, p.height, 1.0e30f};
}

// Every level is read for all lanes and kept where it is wanted: slow, and only the report's own variant asks.
HWY_INLINE vec3 environment_report_radiance(const Environment& e, vec3 d, Real level)
{
    const vec2 uv = equirectangular_from_direction(normalize(d));
    const Real clamped = min(level, e.mip_levels - 1);
    vec3 sum(0.0);
    for (int i = 0; i < e.mip_levels; ++i) {
        const Real weight = max(1.0 - abs(clamped - Real(i)), 0.0);
        if (any_of(weight > 0.0))
            sum += (weight * Real(e.mips[i].scale)) * panorama_bilinear(view(e.mips[i]), uv);
    }
    return sum;
}

HWY_INLINE vec3 environment_report_texel(const Environment& e, vec3 d, Real level)
{
    const vec2 uv = equirectangular_from_direction(normalize(d));
    const Real nearest = floor(min(level, e.mip_levels - 1) + 0.5);
    vec3 sum(0.0);
    for (int i = 0; i < e.mip_levels; ++i)
        if (const auto here = abs(nearest - Real(i)) < 0.5; any_of(here))
            sum += select(here, Real(e.mips[i].scale) * panorama_nearest(view(e.mips[i]), uv), vec3(0.0));
    return sum;
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function" // surfaces are found elsewhere
#include "shading/all.glsl"
#pragma GCC diagnostic pop

// A direction of the world, in the environment's own frame.
vec3 turned(const LightContext& c, vec3 d)
{
    const Real cosine = c.rotation_cosine, sine = c.rotation_sine;
    return vec3(cosine * d.x - sine * d.z, d.y, sine * d.x + cosine * d.z);
}

// The two parts of the directional albedo of GGX, between the table's points.
vec2 albedo_of(Real NV, Real alpha)
{
    constexpr int n = albedo_table_size;
    const Real x = sqrt(clamp(NV, 0.0, 1.0)) * (n - 1),
               y = sqrt(sqrt(clamp(alpha * alpha, 0.0, 1.0))) * (n - 1);
    const Real x0 = min(floor(x), n - 2), y0 = min(floor(y), n - 2);
    const Int index = hn::Mul(hn::Add(hn::Mul(truncated(y0), integer(n)), truncated(x0)), integer(2));
    const float* table = albedo_table;
    const auto at = [&](int offset)
                        HWY_ATTR -> Real { return hn::GatherIndex(FloatTag(), table + offset, index); };
    const Real fx = x - x0, fy = y - y0;
    return vec2(mix(mix(at(0), at(2), fx), mix(at(2 * n), at(2 * n + 2), fx), fy),
                mix(mix(at(1), at(3), fx), mix(at(2 * n + 1), at(2 * n + 3), fx), fy));
}

Metallic metallic_at(const LightContext& c, const Fragments& f, size_t at)
{
    Metallic m = {load3(f, base_r, at), load(f[metalness] + at), load(f[gloss] + at),
                  c.energy_compensation ? 1.0 : 0.0};
    return m;
}

Phong phong_at(const Fragments& f, size_t at)
{
    Phong p = {load3(f, base_r, at), load3(f, specular_r, at), load(f[gloss] + at)};
    return p;
}

Arrival arrival_at(const LightSource& light, vec3 point)
{
    if (!light.local)
        return {-uniform(light.axis), uniform(light.intensity)};
    const LocalLight local = {uniform(light.position), uniform(light.intensity), uniform(light.axis),
                              1.0f / light.range,      light.cos_inner,          light.cos_outer};
    return arrival_from(local, point);
}

void add_direct(const LightContext& c, std::span<const LightSource> lights, size_t at, Fragments& f)
{
    const ShinyPoint s = {load3(f, shading_x, at), load3(f, view_x, at), load3(f, mirrored_dx_x, at),
                          load3(f, mirrored_dy_x, at)};
    const vec3 point = load3(f, position_x, at);
    vec3 sum = load3(f, direct_r, at);
    if (c.model == Model::phong) {
        const Phong p = phong_at(f, at);
        for (const LightSource& light : lights)
            sum += c.pipeline ? direct_phong(p, s.normal, s.view, arrival_at(light, point))
                              : direct_phong_in_pixel(p, s, arrival_at(light, point));
    } else {
        const Metallic m = metallic_at(c, f, at);
        const vec2 albedo = albedo_of(dot(s.normal, s.view), m.alpha);
        for (const LightSource& light : lights)
            sum += direct_metallic_in_pixel(m, albedo, s, arrival_at(light, point));
    }
    store3(sum, f, direct_r, at);
}

ReportTone report_tone(const LightContext& c)
{
    const ReportPowers& p = *c.pipeline;
    return {p.decode, p.exposure, p.encode, p.back};
}

void add_ambient(const LightContext& c, size_t at, Fragments& f)
{
    const environment::IrradianceMap& map = c.environment->irradiance;
    const CubeView cube{map.halfs(), map.log2_size, map.levels};
    const vec3 N = load3(f, shading_x, at);
    const vec3 irradiance = Real(map.scale) * cube_bilinear(cube, turned(c, N), hn::Zero(IntTag()));
    vec3 diffuse = load3(f, base_r, at);
    if (c.model == Model::ggx) {
        const Metallic m = metallic_at(c, f, at);
        diffuse = reflectance_metallic(m, albedo_of(dot(N, load3(f, view_x, at)), m.alpha)).diffuse;
    }
    const Real brightness = Real(c.ambient_brightness) * load(f[occlusion] + at);
    store3(irradiance, f, irradiance_r, at);
    store3(c.pipeline ? ambient_report(report_tone(c), diffuse, irradiance, brightness)
                      : ambient_light(diffuse, irradiance, brightness),
           f, ambient_r, at);
}

// In the environment's own frame.
ShinyPoint shiny_at(const LightContext& c, const Fragments& f, size_t at)
{
    return {turned(c, load3(f, shading_x, at)), turned(c, load3(f, view_x, at)),
            turned(c, load3(f, mirrored_dx_x, at)), turned(c, load3(f, mirrored_dy_x, at))};
}

Mirror mirror_at(const LightContext& c, const Fragments& f, size_t at)
{
    const ShinyPoint s = shiny_at(c, f, at);
    const Real alpha = load(f[gloss] + at);
    return {s, turned(c, uniform(c.across)), alpha, albedo_of(dot(s.normal, s.view), alpha)};
}

void add_specular_phong(const LightContext& c, const Environment& e, size_t at, Fragments& f)
{
    const ShinyPoint s = shiny_at(c, f, at);
    const vec3 across = turned(c, uniform(c.across));
    const Phong p = phong_at(f, at);
    store3(c.pipeline ? specular_pipeline_report(e, report_tone(c), p, s.normal, s.view, across)
           : c.mip_level == MipLevel::report ? specular_phong_report(e, p, s.normal, s.view, across)
                                             : specular_phong(e, p, s, across),
           f, reflected_r, at);
}

void add_specular_ggx(const LightContext& c, const Environment& e, size_t at, Fragments& f)
{
    const Mirror mirror = mirror_at(c, f, at);
    const LobeLight light = specular_ggx(e, mirror);
    const Reflectance r = reflectance_metallic(metallic_at(c, f, at), mirror.albedo);
    store3(r.plain * light.plain + r.grazing * light.grazing, f, reflected_r, at);
}

void add_specular(const LightContext& c, const Environment& e, size_t at, Fragments& f)
{
    if (c.model == Model::phong)
        add_specular_phong(c, e, at, f);
    else
        add_specular_ggx(c, e, at, f);
}

// What these read in the lobe's middle, as a part of the levels that there are.
void find_middle_level(const LightContext& c, const Environment& e, size_t at, Fragments& f)
{
    const Real exponent = load(f[gloss] + at);
    const bool report = c.model == Model::phong && c.mip_level == MipLevel::report;
    const Real level = c.model == Model::ggx ? middle_level_ggx(e, mirror_at(c, f, at))
                       : c.pipeline          ? middle_level_pipeline(e, exponent)
                       : report              ? middle_level_report(e, exponent)
                                             : middle_level_phong(e, shiny_at(c, f, at), exponent);
    store(part_of_levels(level, Real((report ? e.mip_levels : e.levels) - 1)), f[middle_level] + at);
}

Environment environment_of(const LightContext& c, CubeSums& sums)
{
    const environment::CubeChain& chain = c.environment->chain;
    const float deviation = environment::level_one_deviation(chain);
    Environment e{};
    e.sums = &sums;
    e.scale = chain.scale;
    e.variance = deviation * deviation;
    e.levels = chain.levels;
    e.lamps = &c.environment->lamps;
    for (int i = 0; i < 2; ++i)
        e.lamp_variances[i] = environment::level_variance(chain, e.lamps->last_level + i);
    e.mips = c.mip_chain ? c.mip_chain->data() : nullptr;
    e.mip_levels = c.mip_chain ? static_cast<int>(c.mip_chain->size()) : 0;
    e.tables = c.tables;
    e.samples = static_cast<int>(c.tables->cap.size());
    return e;
}

// The lamps through a level's blur, between levels as cube_trilinear, to the extent that the levels are without them.
vec3 lamps_blurred(const environment::Environment& e, vec3 d, float level)
{
    const environment::Lamps& lamps = e.lamps;
    const float clamped = std::min(level, static_cast<float>(e.chain.levels - 1)), fine = std::floor(clamped);
    const float shares[] = {1.0f - (clamped - fine), clamped - fine};
    vec3 sum(0.0);
    for (int i = 0; i < 2; ++i) {
        const int whole = static_cast<int>(fine) + i;
        if (whole <= lamps.last_level || shares[i] <= 0.0f)
            continue;
        for (const environment::Lamp& lamp : lamps.lamps) {
            const vec3 off = d - vec3(lamp.direction[0], lamp.direction[1], lamp.direction[2]);
            const Real density = gaussian_on_sphere(
                dot(off, off), environment::level_variance(e.chain, whole) + lamp.variance);
            sum += (shares[i] * density) * vec3(lamp.light[0], lamp.light[1], lamp.light[2]);
        }
    }
    return sum;
}

} // namespace

HWY_FLATTEN void light_directly(const LightContext& context, std::span<const LightSource> lights,
                                size_t begin, size_t end, Fragments& fragments)
{
    for (size_t at = begin; at < end; at += lane_count)
        add_direct(context, lights, at, fragments);
}

HWY_FLATTEN void light_ambiently(const LightContext& context, size_t begin, size_t end, Fragments& fragments)
{
    for (size_t at = begin; at < end; at += lane_count)
        add_ambient(context, at, fragments);
}

HWY_FLATTEN void light_specularly(const LightContext& context, size_t begin, size_t end, Fragments& fragments)
{
    const environment::CubeChain& chain = context.environment->chain;
    CubeSums sums({chain.halfs(), chain.log2_size, chain.levels});
    const Environment environment = environment_of(context, sums);
    for (size_t at = begin; at < end; at += lane_count)
        add_specular(context, environment, at, fragments);
    if (context.middle_level)
        for (size_t at = begin; at < end; at += lane_count)
            find_middle_level(context, environment, at, fragments);
}

HWY_FLATTEN void light_background(const LightContext& context, const RayMap& rays, const BackgroundRow& row,
                                  float* const rgb[3])
{
    const environment::Environment& e = *context.environment;
    const CubeView chain{e.chain.halfs(), e.chain.log2_size, e.chain.levels};
    const PanoramaView picture = view(e.panorama);
    const vec3 start = uniform(rays.direction) + Real(row.y) * uniform(rays.direction_dy);
    for (int x = 0; x < row.count; x += static_cast<int>(lane_count)) {
        const Real place = Real(hn::Iota(FloatTag(), static_cast<float>(row.first_x + x))) + 0.5;
        const vec3 d = turned(context, normalize(start + place * uniform(rays.direction_dx)));
        vec3 c =
            row.level < 0.0f
                ? Real(e.panorama.scale) * panorama_bilinear(picture, equirectangular_from_direction(d))
                : Real(e.chain.scale) * cube_trilinear(chain, d, row.level) + lamps_blurred(e, d, row.level);
        if (context.pipeline)
            c = toned_report(report_tone(context), c);
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
HWY_EXPORT(light_specularly);
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

void light_specularly(const LightContext& context, std::size_t begin, std::size_t end, Fragments& fragments)
{
    HWY_DYNAMIC_DISPATCH(light_specularly)(context, begin, end, fragments);
}

void light_background(const LightContext& context, const RayMap& rays, const BackgroundRow& row,
                      float* const rgb[3])
{
    HWY_DYNAMIC_DISPATCH(light_background)(context, rays, row, rgb);
}

} // namespace lambent::draw
#endif
