// The report's specular pass. Hooks: see README.md.

// One of the report's samples: its direction about the mirrored view, and its weight F / (4 (w.H)^2) max(N.w, 0) in two
// parts, of which the first is multiplied by Ks: F = Ks * (1 - (1 - VH)^5) + (1 - VH)^5.
struct PhongSample {
    vec3 direction;
    vec2 weights;
    Real NH;
};

// The sample in direction L. Witness: that of specular_phong.
PhongSample phong_sample(vec3 N, vec3 V, vec3 L)
{
    vec3 sum = L + V;
    Real inverse = inversesqrt(max(dot(sum, sum), 2.0e-6));
    Real VH = min(dot(V, sum) * inverse, 1.0);
    Real NL = max(dot(N, L), 0.0);
    Real weight = NL * masking_phong(VH);
    Real grazing = weight * schlick_weight(VH);
    PhongSample s = {L, vec2(weight - grazing, grazing), clamp(dot(N, sum) * inverse, 1.0e-4, 1.0)};
    return s;
}

// Light of the lamps, as far as the level that a sample in their direction reads does not contain them. They are seen
// through the lobe and, with weight growing with pixel.share (0 to 1: how much wider the pixel is than the lobe),
// through the pixel's footprint; the lobe's density is then limited to the footprint's. per_sample is 1 / N.
// Witnesses: the lobe's density times a sample's weight there; a sky full of lamps is a white sky (tests/equations).
vec3 lamps_phong(Environment environment, Phong p, ShinyPoint s, PixelBlur pixel, Real per_sample)
{
    vec3 R = mirrored(s.normal, s.view);
    Footprint footprint = footprint_of(s);
    vec2 variances = lamp_variances(environment);
    Real p2 = pixel.share * pixel.share;
    Real in_pixel = p2 * p2; // of all powers, this one keeps most of a white sky's light
    Real middle = exp2(-log2_lobe_density_phong(0.0, p.exponent));
    Real through_pixel =
        in_pixel * share_of_coarser(variance_of_spread(middle) * per_sample + pixel.variance, variances);
    vec3 total = vec3(0.0);
    for (int i = 0; i < lamp_count(environment); ++i) {
        vec3 L = lamp_direction(environment, i);
        Real log2_xi2 = (p.exponent + 1.0) * log2(max(dot(R, L), 1.0e-4));
        Real density = exp2(max(log2_lobe_density_phong(log2_xi2, p.exponent), -100.0));
        Real share = share_of_coarser(variance_of_spread(1.0 / density) * per_sample + pixel.variance, variances);
        Real seen = share * density / (1.0 + in_pixel * footprint.size * density) +
                    through_pixel * density_in_pixel(footprint, L);
        vec2 weights = seen * phong_sample(s.normal, s.view, L).weights;
        total += (weights.x * p.specular + vec3(weights.y)) * lamp_light(environment, i);
    }
    return total;
}

// The level at which a sample is read, from log2 xi2: for a blur as wide as the share of the lobe that the sample
// represents, plus the pixel's blur. per_sample_level: 1 / N and 1 / v1, with v1 the angular variance of level 1.
// Witness: levels by the lobe's density (tests/equations).
Real matched_level_phong(Real log2_xi2, Real exponent, PixelBlur pixel, vec2 per_sample_level)
{
    Real spread = exp2(-log2_lobe_density_phong(log2_xi2, exponent));
    return level_of_variance((variance_of_spread(spread) * per_sample_level.x + pixel.variance) * per_sample_level.y);
}

// The pixel's contribution to the lobe's samples. Witness: that of pixel_blur.
PixelBlur pixel_blur_phong(ShinyPoint s, Real exponent, Real per_sample)
{
    Real middle = variance_of_spread(exp2(-log2_lobe_density_phong(0.0, exponent))) * per_sample;
    return pixel_blur(s, middle, per_sample);
}

// The level at the lobe's centre, for display as a layer. Witness: levels by the lobe's density (tests/equations).
Real middle_level_phong(Environment environment, ShinyPoint s, Real exponent)
{
    Real per_sample = 1.0 / Real(sample_count(environment));
    PixelBlur pixel = pixel_blur_phong(s, exponent, per_sample);
    return matched_level_phong(0.0, exponent, pixel, vec2(per_sample, 1.0 / level_one_variance(environment)));
}

// The mean of F / (4 (w.H)^2) environment(w) max(N.w, 0) over N samples of the lobe about the mirrored view
// (docs/PHONG.md), each at its own position in the pixel, and read through a blur as wide as the share of lobe and
// pixel that the sample represents. `across` as in Mirror.
// Witness: quadrature over the lobe in a white environment (tests/draw).
vec3 specular_phong(Environment environment, Phong p, ShinyPoint at, vec3 across)
{
    mat3 lobe = carried_frame(mirrored(at.normal, at.view), at.view, across);
    Real per_sample = 1.0 / Real(sample_count(environment));
    vec2 per_sample_level = vec2(per_sample, 1.0 / level_one_variance(environment));
    PixelBlur pixel = pixel_blur_phong(at, p.exponent, per_sample);
    LightSum sum = no_light(environment);
    for (int i = 0; i < sample_count(environment); ++i) {
        vec3 point = lobe_point(environment, i);
        PhongSample s = phong_sample(at.normal, at.view, lobe * sample_phong(point, p.exponent));
        vec2 place = pixel.moved * pixel_point(environment, i);
        vec3 d = s.direction + place.x * at.mirrored_dx + place.y * at.mirrored_dy;
        Real level = matched_level_phong(point.x, p.exponent, pixel, per_sample_level);
        sum = with_light(environment, sum, d, level, s.weights);
    }
    return (p.specular * first_light(environment, sum) + second_light(environment, sum)) * per_sample +
           lamps_phong(environment, p, at, pixel, per_sample);
}

// The first term of the report's level, 1/2 log2(W H / N). Witness: levels by the report's formula (tests/equations).
Real first_term_of_report(Environment environment)
{
    return report_base_level(environment) - 0.5 * log2(Real(sample_count(environment)));
}

// The report's own choice of mip level, first_term - 1/2 log2(D(H) / 4), at least 0. The first term lacks the solid
// angle of the sphere, 4 pi, which makes levels 1.83 too coarse.
// Witness: levels by the report's formula (tests/equations).
Real report_level_phong(Real first_term, Real NH, Real exponent)
{
    return max(first_term - 0.5 * (log2_density_phong(NH, exponent) - 2.0), 0.0);
}

// The same at the lobe's centre, where H is N, for display as a layer.
// Witness: levels by the report's formula (tests/equations).
Real middle_level_report(Environment environment, Real exponent)
{
    return report_level_phong(first_term_of_report(environment), 1.0, exponent);
}

// The specular pass with the report's own choice of mip level, in the panorama's own mip chain: narrow lobes show the
// texels of a level as blocks. Witness: levels by the report's formula (tests/equations).
vec3 specular_phong_report(Environment environment, Phong p, vec3 N, vec3 V, vec3 across)
{
    mat3 lobe = carried_frame(mirrored(N, V), V, across);
    Real first_term = first_term_of_report(environment);
    vec3 total = vec3(0.0);
    for (int i = 0; i < sample_count(environment); ++i) {
        PhongSample s = phong_sample(N, V, lobe * sample_phong(lobe_point(environment, i), p.exponent));
        Real level = report_level_phong(first_term, s.NH, p.exponent);
        vec3 weight = s.weights.x * p.specular + vec3(s.weights.y);
        total += weight * environment_report_radiance(environment, s.direction, level);
    }
    return total / Real(sample_count(environment));
}
