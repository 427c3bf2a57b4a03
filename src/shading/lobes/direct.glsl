// Reflection of light from sources without size. Hook: has_stretch, see README.md.

// Arriving light that a surface reflects towards V: BRDF times illuminance times the cosine.
// Witness: an independent GGX in double (tests/draw).
vec3 direct_metallic(Metallic m, vec2 albedo, vec3 N, vec3 V, Arrival a)
{
    Real NL = dot(N, a.direction);
    vec3 L = select(NL > 0.0, a.direction, N);
    vec3 f = vec3(0.0);
    if (has_stretch() != 0 && any_of(is_stretched(m.alpha)))
        f = brdf_metallic(m, albedo, frame_along(N, m.tangent), V, L);
    else
        f = brdf_metallic(m, albedo, N, V, L);
    return select(NL > 0.0, (NL * f) * a.illuminance, vec3(0.0));
}

// The same with the report's BRDF. Witness: its closed form at 60 degrees and at normal incidence (tests/draw).
vec3 direct_phong(Phong p, vec3 N, vec3 V, Arrival a)
{
    Real NL = dot(N, a.direction);
    vec3 f = brdf_phong(p, N, V, select(NL > 0.0, a.direction, N));
    return select(NL > 0.0, (NL * f) * a.illuminance, vec3(0.0));
}

// Whether light from L may cause a highlight narrower than the directions that the surface mirrors within the pixel.
// One sample at the pixel's centre could then miss it, or show it in the whole pixel. A lobe of roughness alpha is
// about 2 alpha wide in mirrored directions; of two alphas the smaller says how narrow it is, the larger how far it
// reaches. Witness: both sides of each bound (tests/equations).
Mask hides_highlight(ShinyPoint s, vec2 alpha, vec3 L)
{
    Real turn2 = dot(s.mirrored_dx, s.mirrored_dx) + dot(s.mirrored_dy, s.mirrored_dy);
    vec3 off = mirrored(s.normal, s.view) - L;
    Real reach = sqrt(turn2) + 6.0 * max(alpha.x, alpha.y);
    Real narrow = min(alpha.x, alpha.y);
    return turn2 > narrow * narrow && dot(off, off) < reach * reach;
}

// The normal of sample i of 64 in the pixel, eight by eight: the one that mirrors the view of the pixel's centre to the
// direction that the surface mirrors at the sample's position. Mirrored directions stay above the horizon, because at a
// silhouette the pixel is wider than the surface visible in it.
// Witness: mean and variance of the mirrored directions are the pixel's (tests/equations).
vec3 normal_of_look(ShinyPoint s, int i)
{
    Real x = 0.125 * Real(i % 8) - 0.4375;
    Real y = 0.125 * Real(i / 8) - 0.4375;
    vec3 way = mirrored(s.normal, s.view) + x * s.mirrored_dx + y * s.mirrored_dy;
    return normalize(s.view + normalize(way + max(-dot(s.normal, way), 0.0) * s.normal));
}

// The material with its lobe widened by the change of mirrored directions over a pixel.
// Witness: that of alpha_in_pixel.
Metallic widened(Metallic m, vec3 mirrored_dx, vec3 mirrored_dy)
{
    Metallic wide = m;
    wide.alpha = vec2(alpha_in_pixel(m.alpha.x, mirrored_dx, mirrored_dy));
    if (has_stretch() != 0)
        wide.alpha.y = alpha_in_pixel(m.alpha.y, mirrored_dx, mirrored_dy);
    return wide;
}

// direct_metallic averaged over the 64 samples of the pixel, each of the lobe widened by an eighth of the pixel.
// Witness: that of direct_metallic_in_pixel.
ONE_BODY vec3 direct_metallic_in_looks(Metallic m, vec2 albedo, ShinyPoint s, Arrival a)
{
    Metallic narrow = widened(m, 0.125 * s.mirrored_dx, 0.125 * s.mirrored_dy);
    vec3 sum = vec3(0.0);
    // Four samples in each iteration: some software devices end all loops after 65535 iterations in total, which
    // a thousand lights would exceed.
    for (int i = 0; i < 64; i += 4)
        sum += direct_metallic(narrow, albedo, normal_of_look(s, i), s.view, a) +
               direct_metallic(narrow, albedo, normal_of_look(s, i + 1), s.view, a) +
               direct_metallic(narrow, albedo, normal_of_look(s, i + 2), s.view, a) +
               direct_metallic(narrow, albedo, normal_of_look(s, i + 3), s.view, a);
    return 0.015625 * sum;
}

// direct_metallic averaged over the pixel: one sample of the lobe widened by the pixel, or, for highlights narrower
// than the pixel, 64 samples.
// Witness: quadrature over the pixel (tests/equations).
vec3 direct_metallic_in_pixel(Metallic m, vec2 albedo, ShinyPoint s, Arrival a)
{
    vec3 once = direct_metallic(widened(m, s.mirrored_dx, s.mirrored_dy), albedo, s.normal, s.view, a);
    Mask hidden = hides_highlight(s, m.alpha, a.direction);
    if (any_of(hidden))
        once = select(hidden, direct_metallic_in_looks(m, albedo, s, a), once);
    return once;
}

// The same for direct_phong, whose lobe is widened for the 64 samples only.
// Witness: quadrature over the pixel (tests/equations).
vec3 direct_phong_in_pixel(Phong p, ShinyPoint s, Arrival a)
{
    vec3 once = direct_phong(p, s.normal, s.view, a);
    Mask hidden = hides_highlight(s, vec2(phong_alpha(p.exponent)), a.direction);
    if (any_of(hidden)) {
        Real alpha = alpha_in_pixel(phong_alpha(p.exponent), 0.125 * s.mirrored_dx, 0.125 * s.mirrored_dy);
        Phong narrow = {p.diffuse, p.specular, phong_exponent(alpha)};
        vec3 sum = vec3(0.0);
        for (int i = 0; i < 64; i += 4)
            sum += direct_phong(narrow, normal_of_look(s, i), s.view, a) +
                   direct_phong(narrow, normal_of_look(s, i + 1), s.view, a) +
                   direct_phong(narrow, normal_of_look(s, i + 2), s.view, a) +
                   direct_phong(narrow, normal_of_look(s, i + 3), s.view, a);
        once = select(hidden, 0.015625 * sum, once);
    }
    return once;
}
