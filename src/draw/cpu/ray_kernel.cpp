#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "draw/cpu/ray_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "albedo/albedo_table.h"
#include "draw/cpu/ray_kernel.h"

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
#pragma GCC diagnostic ignored "-Wunused-function"  // those of other passes
#pragma GCC diagnostic ignored "-Wunused-parameter" // in code made from empty lists
#include "shading/all.glsl"
#include "shading/light_passes.glsl"
#include "shading/ray_pass.glsl"
#pragma GCC diagnostic pop

// (xi2, cos 2 pi xi1, sin 2 pi xi1) of two random numbers.
HWY_INLINE vec3 random_point(const Fragment& f, int xi2, int xi1)
{
    // A polynomial would do; the angle's exact value does not matter, its distribution does.
    alignas(64) float angle[max_lanes], cosine[max_lanes], sine[max_lanes];
    store(6.283185307179586 * load(f, xi1), angle);
    for (size_t i = 0; i < lane_count; ++i)
        cosine[i] = std::cos(angle[i]), sine[i] = std::sin(angle[i]);
    return vec3(load(f, xi2), load(cosine), load(sine));
}

// Two independent normally distributed numbers. [Box and Muller 1958]
HWY_INLINE vec2 random_normals(const Fragment& f, int xi2, int xi1)
{
    const vec3 point = random_point(f, xi2, xi1);
    const Real radius = sqrt(-1.3862943611198906 * log2(max(1.0 - point.x, 1.0e-7)));
    return vec2(radius * point.y, radius * point.z);
}

void store_lobe_ray(const Fragment& f, const LobeRay& ray)
{
    store3(f, lobe_way, ray.direction);
    store3(f, lobe_diffuse, ray.share.diffuse);
    store3(f, lobe_glossy, ray.share.glossy);
    store3(f, lobe_radiance, ray.radiance);
    store(f, lobe_density, ray.density);
}

void store_lamp_ray(const Fragment& f, int way, const LampRay& ray)
{
    const TwoParts light = chosen_light(ray);
    store3(f, way, ray.direction);
    store3(f, way + 3, light.diffuse);
    store3(f, way + 6, light.glossy);
}

// A ray to one of the scene's lights, and its length.
void choose_light(const Environment& e, const RayOrigin& o, std::span<const LightSource> lights,
                  const Fragment& f)
{
    LampRay ray = no_lamp_ray(load(f, random_light));
    for (const LightSource& light : lights) {
        const Arrival a = arrival_of({uniform(light.position), uniform(light.intensity), uniform(light.axis),
                                      1.0f / light.range, light.cos_inner, light.cos_outer},
                                     light.local, o.receiver.point);
        const vec3 way = uniform(light.position) - o.receiver.point;
        ray = or_lamp(ray, a.direction, light.local ? sqrt(dot(way, way)) : Real(1.0e30),
                      reflected_parts(e, o.receiver, a));
    }
    store_lamp_ray(f, light_way, ray);
    store(f, light_distance, select(ray.total > 0.0, ray.distance, 0.0));
}

void choose_at(const Environment& e, const RayChoice& choice, const Fragment& f)
{
    const RayOrigin o = ray_origin(e, f);
    const vec3 way = drawn_ray(e, o, load(f, random_lobe), random_point(f, random_xi2, random_xi1));
    if (e.context->environment) {
        store_lobe_ray(f, lobe_ray(e, o, way, choice.rays));
        store_lamp_ray(f, lamp_way,
                       environment_lamp_ray(e, o, choice.rays, load(f, random_lamp),
                                            random_normals(f, random_lamp_xi2, random_lamp_xi1)));
    } else {
        store_lobe_ray(f, dark_lobe_ray(e, o, way));
        store_lamp_ray(f, lamp_way, no_lamp_ray(0.0));
    }
    choose_light(e, o, choice.lights, f);
}

// The alpha of lobe `number` widened by its footprint, which becomes a point.
HWY_INLINE void soften_lobe(const Fragment& f, int number, int alpha)
{
    const ShinyPoint s = load_shine(f, number);
    store(f, alpha, alpha_in_pixel(load(f, alpha), s.mirrored_dx, s.mirrored_dy));
    const int column = column_shine + columns_per_shine * number;
    store3(f, column + 3, vec3(0.0));
    store3(f, column + 6, vec3(0.0));
}

} // namespace

HWY_FLATTEN void soften(Model model, size_t begin, size_t end, Fragments& fragments)
{
    const bool phong = model == Model::phong, layers = takes_layers(phong ? model_phong : model_ggx) != 0;
    for (size_t at = begin; at < end; at += lane_count) {
        const Fragment f = fragment(fragments, at);
#define LAYER(name, number, texture)                                                                         \
    if (layers && any_of(load(f, column_##name) > 0.0))                                                      \
        soften_lobe(f, number, column_##name##_alpha);
#include "shading/lobes/layers.h"
        const ShinyPoint s = load_shine(f, 0);
        if (phong)
            store(f, column_exponent,
                  phong_exponent(
                      alpha_in_pixel(phong_alpha(load(f, column_exponent)), s.mirrored_dx, s.mirrored_dy)));
        soften_lobe(f, 0, column_alpha);
    }
}

HWY_FLATTEN void choose_rays(const LightContext& context, const RayChoice& choice, size_t begin, size_t end,
                             Fragments& fragments)
{
    const environment::CubeChain none;
    const environment::CubeChain& chain = context.environment ? context.environment->chain : none;
    CubeSums sums({chain.halfs(), chain.log2_size, chain.levels});
    const Environment e = environment_of(context, &sums);
    for (size_t at = begin; at < end; at += lane_count)
        choose_at(e, choice, fragment(fragments, at));
}

} // namespace lambent::draw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::draw {

HWY_EXPORT(soften);
HWY_EXPORT(choose_rays);

void soften(Model model, std::size_t begin, std::size_t end, Fragments& fragments)
{
    HWY_DYNAMIC_DISPATCH(soften)(model, begin, end, fragments);
}

void choose_rays(const LightContext& context, const RayChoice& choice, std::size_t begin, std::size_t end,
                 Fragments& fragments)
{
    HWY_DYNAMIC_DISPATCH(choose_rays)(context, choice, begin, end, fragments);
}

} // namespace lambent::draw
#endif
