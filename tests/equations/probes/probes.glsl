// Every function of the equations, called with arguments made from eight numbers in [0, 1): the same text again,
// so that it compiles as GLSL, over lanes and in double, and the three can be compared. Listed in
// probes_list.h; a test fails when a function of the text is not called here. Arguments are made with
// additions, multiplications and one normalisation, so that little rounding goes in.

struct Inputs {
    Real a;
    Real b;
    Real c;
    Real d;
    Real e;
    Real f;
    Real g;
    Real h;
};

struct Outputs {
    Real x;
    Real y;
    Real z;
    Real w;
};

Outputs outputs(vec3 v, Real w)
{
    Outputs o = {v.x, v.y, v.z, w};
    return o;
}

// From low to high, dense near low: about as many samples in each decade.
Real decades(Real u, Real low, Real high)
{
    Real u2 = u * u;
    Real u4 = u2 * u2;
    return low + (high - low) * u4 * u4;
}

vec3 decades(vec3 u, Real low, Real high)
{
    return vec3(decades(u.x, low, high), decades(u.y, low, high), decades(u.z, low, high));
}

// Unit direction: the octahedron's surface laid out on the square. [Meyer et al. 2010]
vec3 direction(Real u, Real v)
{
    Real x = 2.0 * u - 1.0;
    Real y = 2.0 * v - 1.0;
    Real z = 1.0 - abs(x) - abs(y);
    Real over = max(-z, 0.0);
    return normalize(vec3(select(x < 0.0, x + over, x - over), select(y < 0.0, y + over, y - over), z));
}

// The same over the hemisphere about +z, cosine at least 0.002.
vec3 upper_direction(Real u, Real v)
{
    Real x = u - v;
    Real y = u + v - 1.0;
    return normalize(vec3(x, y, 1.002 - abs(x) - abs(y)));
}

// Cosine and sine of an angle, without either function: the rational circle, both halves.
vec2 turn(Real u)
{
    Real t = 4.0 * abs(u - 0.5) - 1.0;
    Real inverse = 1.0 / (1.0 + t * t);
    return vec2(2.0 * t * inverse, select(u < 0.5, -1.0, 1.0) * (1.0 - t * t) * inverse);
}

// A direction about an axis that is at most about 0.002 off it, and 1e-8 at the least.
vec3 beside(vec3 axis, Inputs i)
{
    return normalize(axis + decades(i.c, 1.0e-8, 2.0e-3) * direction(i.d, i.e));
}

// fresnel.glsl

Outputs fresnel(Inputs i)
{
    return outputs(fresnel_schlick(vec3(i.a, i.b, i.c), i.d), schlick_weight(i.d));
}

Outputs lobe_weights(Inputs i)
{
    Real versine = 0.9 * i.a;
    LobeWeight g = lobe_weight_ggx(1.0 - versine, versine, 0.1 + 0.9 * i.b);
    LobeWeight p = lobe_weight_phong(1.0 - versine, versine, 1.0 + 3.0 * i.c);
    LobeSum dim = {vec3(i.d), 1.0 + i.e};
    LobeSum bright = {vec3(i.f), 0.1 * i.g};
    return outputs(vec3(g.value, 0.1 * g.curvature, p.value), p.curvature + mean_of_lobe(dim, bright, 2.0).x);
}

Outputs fresnel_base(Inputs i)
{
    return outputs(base_reflectance(vec3(i.a, i.b, i.c), i.d), dielectric_reflectance());
}

// frame.glsl

Outputs frame_matrix(Inputs i)
{
    mat3 frame = orthonormal_frame(direction(i.a, i.b));
    return outputs(frame * vec3(i.c, i.d, i.e),
                   dot(frame * vec3(1.0, 0.0, 0.0), frame * vec3(0.0, 1.0, 0.0)));
}

// V within 60 degrees or so of N, and `across` not along V.
Outputs frame_carried(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    vec3 V = normalize(N + 0.8 * direction(i.c, i.d));
    vec3 any = direction(i.e, i.f);
    vec3 across = normalize(any - 0.9 * dot(any, V) * V);
    mat3 frame = carried_frame(N, V, across);
    return outputs(in_frame(frame, direction(i.g, i.h)), dot(frame * vec3(i.e, i.f, i.g), V));
}

// The frame where V almost is N.
Outputs frame_carried_little(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    mat3 frame = carried_frame(N, beside(N, i), mirrored(vec3(0.6, 0.0, 0.8), N));
    vec3 x = frame * vec3(1.0, 0.0, 0.0);
    vec3 y = frame * vec3(0.0, 1.0, 0.0);
    return outputs(vec3(dot(x, x), dot(y, y), dot(x, N)), dot(y, N));
}

Outputs frame_mirrored(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    vec3 V = direction(i.c, i.d);
    return outputs(mirrored(N, V), dot(N, V));
}

Outputs frame_facing(Inputs i)
{
    vec3 V = direction(i.c, i.d);
    vec3 N = facing_normal(direction(i.a, i.b), V, 1.0e-3 + 0.08 * i.e);
    return outputs(N, dot(N, V));
}

// phong.glsl

Outputs phong_density(Inputs i)
{
    Outputs o = {log2_density_phong(max(i.a, 1.0e-4), decades(i.b, 0.01, 1.0e6)), 0.0, 0.0, 0.0};
    return o;
}

Outputs phong_terms(Inputs i)
{
    Outputs o = {log2_density_phong(max(i.a, 1.0e-4), 100.0 * i.b + 0.01),
                 log2_lobe_density_phong(-20.0 * i.c, decades(i.b, 0.01, 1.0e6)), masking_phong(i.d),
                 phong_exponent(decades(i.e, 1.0e-4, 1.0))};
    return o;
}

Outputs phong_sample(Inputs i)
{
    vec2 t = turn(i.b);
    Real exponent = decades(i.c, 0.01, 1.0e6);
    return outputs(sample_phong(vec3(-20.0 * i.a, t.x, t.y), exponent), phong_alpha(exponent));
}

Outputs phong_brdf_up_to(Inputs i, Real most)
{
    vec3 N = direction(i.a, i.b);
    mat3 frame = orthonormal_frame(N);
    Phong p = {vec3(i.g, i.h, 0.5), vec3(0.04, i.h, i.g), decades(i.a, 0.01, most)};
    return outputs(brdf_phong(p, N, frame * upper_direction(i.c, i.d), frame * upper_direction(i.e, i.f)),
                   0.0);
}

Outputs phong_brdf(Inputs i)
{
    return phong_brdf_up_to(i, 100.0);
}

Outputs phong_brdf_sharp(Inputs i)
{
    return phong_brdf_up_to(i, 1.0e4);
}

// ggx.glsl

Outputs ggx_density(Inputs i)
{
    Real alpha = decades(i.b, 1.0e-4, 1.0);
    Outputs o = {density_ggx(i.a, alpha), density_ggx(Real(1.0), alpha), density_ggx(i.a, i.c + 0.001), 0.0};
    return o;
}

Outputs ggx_masking(Inputs i)
{
    Real alpha = decades(i.c, 1.0e-4, 1.0);
    Outputs o = {smith_ggx(i.a, alpha), masking_ggx(i.a, alpha), spread_ggx(i.a, smith_ggx(i.a, alpha), vec2(alpha)),
                 reflecting_share_ggx(vec3(sqrt((1.0 - i.a) * (1.0 + i.a)), 0.0, i.a), vec2(alpha))};
    return o;
}

Outputs ggx_pair(Inputs i)
{
    Real alpha = decades(i.c, 1.0e-4, 1.0);
    Real NL = max(i.a, 1.0e-3);
    Real NV = max(i.b, 1.0e-3);
    Outputs o = {visibility_ggx(NL, NV, alpha), shadowing_ggx(NL, NV, alpha), 0.0, 0.0};
    return o;
}

Outputs ggx_two(Inputs i)
{
    vec2 alpha = vec2(0.1 + 0.9 * i.e, 0.1 + 0.9 * i.f);
    vec3 L = upper_direction(i.a, i.b);
    vec3 V = upper_direction(i.c, i.d);
    Outputs o = {density_ggx(L, alpha), smith_ggx(V, alpha), visibility_ggx(L, V, alpha), slope_ggx(L, alpha)};
    return o;
}

Outputs ggx_two_sample(Inputs i)
{
    vec2 alpha = vec2(0.1 + 0.9 * i.e, 0.1 + 0.9 * i.f);
    vec2 t = turn(i.b);
    vec3 view = upper_direction(i.c, i.d);
    VisibleFacet facet = sample_visible_ggx(stretched_view(view, alpha), alpha, vec3(min(i.a, 0.9990234375), t.x, t.y));
    return outputs(facet.normal, facet.spread);
}

Outputs ggx_stretched(Inputs i)
{
    return outputs(stretched_view(upper_direction(i.a, i.c), vec2(decades(i.b, 1.0e-4, 1.0), decades(i.d, 1.0e-4, 1.0))), 0.0);
}

// Spreads reach 1 / alpha^4: with the factor that all facets of the view share, and as a logarithm.
Outputs ggx_sample_of(Inputs i, Real xi2, Real alpha)
{
    vec2 t = turn(i.b);
    Real NV = max(i.c, 1.0e-3);
    vec3 view = vec3(sqrt((1.0 - NV) * (1.0 + NV)), 0.0, NV);
    VisibleFacet facet = sample_visible_ggx(stretched_view(view, vec2(alpha)), vec2(alpha), vec3(xi2, t.x, t.y));
    return outputs(facet.normal, log2(facet.spread * spread_ggx(NV, smith_ggx(NV, alpha), vec2(alpha))));
}

Outputs ggx_sample(Inputs i)
{
    return ggx_sample_of(i, min(i.a, 0.9990234375), decades(i.d, 0.05, 1.0));
}

Outputs ggx_sample_smooth(Inputs i)
{
    return ggx_sample_of(i, min(i.a, 0.9990234375), decades(i.d, 1.0e-4, 0.05));
}

Outputs ggx_sample_last(Inputs i)
{
    return ggx_sample_of(i, i.a, decades(i.d, 1.0e-4, 1.0));
}

// energy.glsl

vec2 probe_albedo(Real u, Real v)
{
    return vec2((1.0 - 0.3 * u) * (1.0 - 0.2 * v), (1.0 - 0.3 * u) * 0.2 * v);
}

Outputs energy_factor(Inputs i)
{
    return outputs(energy_compensation(vec3(i.a, i.b, i.c), vec2(0.1 + 0.8 * i.d, 0.1 * i.e), i.f), 0.0);
}

Outputs energy_reflectance(Inputs i)
{
    Metallic m = {vec3(i.a, i.b, i.c), i.d, vec2(i.e), vec3(0.0), i.h};
    Reflectance r = reflectance_metallic(m, probe_albedo(i.f, i.g));
    return outputs(r.plain + 2.0 * r.grazing + 3.0 * r.diffuse, r.diffuse.x);
}

Outputs energy_brdf_of(Inputs i, Real alpha)
{
    vec3 N = direction(i.a, i.b);
    mat3 frame = orthonormal_frame(N);
    Metallic m = {vec3(i.g, i.h, 0.5), i.h, vec2(alpha), vec3(0.0), i.f};
    vec3 V = frame * upper_direction(i.c, i.d);
    return outputs(brdf_metallic(m, probe_albedo(i.g, i.h), N, V, frame * upper_direction(i.e, i.f)), 0.0);
}

Outputs energy_brdf_two(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    mat3 frame = frame_along(N, mirrored(N, vec3(0.8, 0.0, 0.6)));
    Metallic m = {vec3(i.g, i.h, 0.5), i.h, vec2(0.2 + 0.8 * i.a, 0.2 + 0.8 * i.f), vec3(0.0), i.f};
    vec3 L = frame * upper_direction(i.e, i.f);
    vec3 V = frame * upper_direction(i.c, i.d);
    return outputs(brdf_metallic(m, probe_albedo(i.g, i.h), frame, V, L),
                   brdf_of_lobe(m, probe_albedo(i.g, i.h), i.c, i.d).y);
}

Outputs energy_brdf(Inputs i)
{
    return energy_brdf_of(i, 0.2 + 0.8 * i.a);
}

Outputs energy_brdf_smooth(Inputs i)
{
    return energy_brdf_of(i, 0.02 + 0.2 * i.a);
}

// lights.glsl

Outputs light_attenuations(Inputs i)
{
    Real inner = 2.0 * i.c - 1.0;
    Real distance2 = decades(i.a, 1.0e-4, 1.0e6);
    Outputs o = {distance_attenuation(distance2, decades(i.b, 1.0e-3, 10.0)),
                 distance_attenuation(distance2, 0.0),
                 cone_attenuation(2.0 * i.d - 1.0, inner, inner - 0.1 - i.e), 0.0};
    return o;
}

// sphere_maps.glsl

Outputs map_from_direction(Inputs i)
{
    vec2 uv = equirectangular_from_direction(direction(i.a, i.b));
    Outputs o = {uv.x, uv.y, 0.0, 0.0};
    return o;
}

Outputs map_direction(Inputs i)
{
    return outputs(direction_from_equirectangular(vec2(i.a, i.b)), 0.0);
}

Outputs map_cube(Inputs i)
{
    Real s = 2.0 * i.a - 1.0;
    Real t = 2.0 * i.b - 1.0;
    vec3 sum = direction_from_cube(0, s, t) + 2.0 * direction_from_cube(1, s, t) +
               4.0 * direction_from_cube(2, s, t) + 8.0 * direction_from_cube(3, s, t) +
               16.0 * direction_from_cube(4, s, t) + 32.0 * direction_from_cube(5, s, t);
    return outputs(sum, cube_corner_solid_angle(s, t));
}

Outputs map_cube_place(Inputs i)
{
    CubePlace p = cube_from_direction(vec3(2.0 * i.a - 1.0, 2.0 * i.b - 1.0, 2.0 * i.c - 1.0));
    return outputs(vec3(p.face, p.s, p.t), 0.0);
}

// spherical_harmonics.glsl

Outputs sh_values(Inputs i)
{
    Harmonics h = harmonics(direction(i.a, i.b));
    Outputs o = {h.c0 + 2.0 * h.c1 + 3.0 * h.c2, h.c3 + 2.0 * h.c4 + 3.0 * h.c5,
                 h.c6 + 2.0 * h.c7 + 3.0 * h.c8, h.c2};
    return o;
}

Outputs sh_irradiance(Inputs i)
{
    Harmonics L = {i.c, i.d, -i.e, i.f, i.g, -i.h, i.c - i.d, i.e, i.f - i.g};
    Outputs o = {harmonic_irradiance(L, direction(i.a, i.b)), 0.0, 0.0, 0.0};
    return o;
}

// footprint.glsl

Outputs footprint_levels(Inputs i)
{
    Outputs o = {level_of_variance(decades(i.a, 1.0e-3, 1.0e7)), level_of_variance(4.0 * i.b),
                 variance_of_spread(decades(i.c, 1.0e-8, 10.0)) + part_of_levels(4.0 * i.h - 1.0, 2.0) + shared_cosine(i.h, 0.9),
                 share_of_coarser(i.d, vec2(0.2, 0.3 + 0.5 * i.e)) + 0.01 * gaussian_on_sphere(4.0 * i.f, 0.05 + i.g)};
    return o;
}

// transfer.glsl

Outputs transfer_curves(Inputs i)
{
    Real light = decades(i.a, 0.0, 1.0);
    return outputs(srgb_encode(vec3(light, i.b, 0.01 * i.c)), srgb_decode(i.d));
}

Outputs transfer_powers(Inputs i)
{
    Outputs o = {power(decades(i.a, 0.0, 1.0), 2.2), power(i.b, 0.1 + 4.0 * i.c), srgb_encode(0.01 * i.d),
                 srgb_decode(0.1 * i.e)};
    return o;
}

Outputs transfer_colour(Inputs i)
{
    return outputs(power(vec3(i.a, i.b, i.c), 0.4 + 2.0 * i.d), 0.0);
}

// tone.glsl, over black to 100,000; and near white, where the curves bend.

vec3 any_light(Inputs i)
{
    return decades(vec3(i.a, i.b, i.c), 0.0, 1.0e5);
}

vec3 some_light(Inputs i)
{
    return 2.0 * vec3(i.a, i.b, i.c);
}

Outputs tone_simple(Inputs i)
{
    return outputs(tone_reinhard(any_light(i)), dot(tone_linear(any_light(i)), vec3(1.0, 2.0, 4.0)));
}

Outputs tone_neutral_any(Inputs i)
{
    return outputs(tone_neutral(any_light(i)), 0.0);
}

Outputs tone_neutral_some(Inputs i)
{
    return outputs(tone_neutral(some_light(i)), 0.0);
}

Outputs tone_aces_any(Inputs i)
{
    return outputs(tone_aces(any_light(i)), 0.0);
}

Outputs tone_aces_some(Inputs i)
{
    return outputs(tone_aces(some_light(i)), 0.0);
}

Outputs tone_agx_any(Inputs i)
{
    return outputs(tone_agx(any_light(i)), agx_sigmoid(i.d));
}

Outputs tone_agx_some(Inputs i)
{
    return outputs(tone_agx(some_light(i)), agx_sigmoid(0.55 + 0.1 * i.d));
}
