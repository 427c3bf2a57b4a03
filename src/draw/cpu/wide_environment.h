// Lookups of the light passes in SIMD lanes: hooks of src/shading/README.md. Included after wide/wide.h,
// wide_fragments.h, wide_cube.h, wide_panorama.h and shading/numbers.glsl, inside the target's namespace: no guard.

// The data that the hooks read.
struct Environment {
    const LightContext* context;
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
    float background_level;   // of blur; negative: the panorama itself
    float level_shares[2];    // weights of the two levels that it lies between; 0 for levels with lamps
    float level_variances[2]; // angular variances of these levels
};

// Materials have no anisotropy: no facets have two different alphas.
HWY_INLINE int has_stretch()
{
    return 0;
}

HWY_INLINE int model_of(const Environment& e)
{
    return e.context->model == Model::phong ? model_phong : model_ggx;
}

HWY_INLINE int levels_of(const Environment& e)
{
    if (e.context->pipeline)
        return levels_pipeline;
    return e.context->mip_level == MipLevel::report ? levels_report : levels_matched;
}

HWY_INLINE Real compensation_of(const Environment& e)
{
    return e.context->energy_compensation ? 1.0 : 0.0;
}

HWY_INLINE Real ambient_brightness(const Environment& e)
{
    return e.context->ambient_brightness;
}

HWY_INLINE ReportTone report_tone(const Environment& e)
{
    const ReportPowers& p = *e.context->pipeline;
    return {p.decode, p.exposure, p.encode, p.back};
}

HWY_INLINE vec3 across_of(const Environment& e)
{
    return uniform(e.context->across);
}

// A world direction in the environment's own frame.
HWY_INLINE vec3 turned(const Environment& e, vec3 d)
{
    const Real cosine = e.context->rotation_cosine, sine = e.context->rotation_sine;
    return vec3(cosine * d.x - sine * d.z, d.y, sine * d.x + cosine * d.z);
}

// The inverse of turned().
HWY_INLINE vec3 in_world(const Environment& e, vec3 d)
{
    const Real cosine = e.context->rotation_cosine, sine = e.context->rotation_sine;
    return vec3(cosine * d.x + sine * d.z, d.y, cosine * d.z - sine * d.x);
}

HWY_INLINE vec3 environment_irradiance(const Environment& e, vec3 d)
{
    const environment::IrradianceMap& map = e.context->environment->irradiance;
    return Real(map.scale) * cube_bilinear({map.halfs(), map.log2_size, map.levels}, d, hn::Zero(IntTag()));
}

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

HWY_INLINE Real lamp_variance(const Environment& e, int i)
{
    return e.lamps->lamps[static_cast<size_t>(i)].variance;
}

HWY_INLINE vec2 lamp_variances(const Environment& e)
{
    return vec2(e.lamp_variances[0], e.lamp_variances[1]);
}

HWY_INLINE Real highest_level(const Environment& e)
{
    return e.levels - 1;
}

HWY_INLINE Real highest_report_level(const Environment& e)
{
    return e.mip_levels - 1;
}

// The sums are stored in Environment::sums; the shared code passes this empty value around.
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
    // NOLINTNEXTLINE(clang-analyzer-core.NullDereference): called only where the mip chain exists
    return 0.5f * std::log2(static_cast<float>(e.mips[0].width) * static_cast<float>(e.mips[0].height));
}

PanoramaView view(const environment::Panorama& p)
{
    return {reinterpret_cast<const int32_t*>(p.texels.data()), p.width, p.height, 1.0e30f};
}

// Reads every level that some lane needs, for all lanes: slow, but used only for the report's levels.
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

HWY_INLINE int background_of(const Environment& e)
{
    return e.background_level < 0.0f ? background_panorama : background_blurred;
}

HWY_INLINE vec3 environment_panorama(const Environment& e, vec3 d)
{
    const environment::Panorama& p = e.context->environment->panorama;
    return Real(p.scale) * panorama_bilinear(view(p), equirectangular_from_direction(d));
}

HWY_INLINE vec3 environment_blurred(const Environment& e, vec3 d)
{
    const environment::CubeChain& chain = e.context->environment->chain;
    return Real(chain.scale) *
           cube_trilinear({chain.halfs(), chain.log2_size, chain.levels}, d, e.background_level);
}

HWY_INLINE int is_without_lamps(const Environment& e, int level)
{
    return e.level_shares[level] > 0.0f;
}

HWY_INLINE Real share_of_level(const Environment& e, int level)
{
    return e.level_shares[level];
}

HWY_INLINE Real variance_of_level(const Environment& e, int level)
{
    return e.level_variances[level];
}

Environment environment_of(const LightContext& c, CubeSums* sums)
{
    Environment e{};
    e.context = &c;
    e.sums = sums;
    e.tables = c.tables;
    e.samples = static_cast<int>(c.tables->cap.size());
    if (!c.environment)
        return e;
    const environment::CubeChain& chain = c.environment->chain;
    const float deviation = environment::level_one_deviation(chain);
    e.scale = chain.scale;
    e.variance = deviation * deviation;
    e.levels = chain.levels;
    e.lamps = &c.environment->lamps;
    for (int i = 0; i < 2; ++i)
        e.lamp_variances[i] = environment::level_variance(chain, e.lamps->last_level + i);
    e.mips = c.mip_chain ? c.mip_chain->data() : nullptr;
    e.mip_levels = c.mip_chain ? static_cast<int>(c.mip_chain->size()) : 0;
    return e;
}
