// What surfaces send to the viewer of light of sources without size. Hook: has_stretch, see README.md.

// What a surface sends towards V of light that arrives: BRDF times illuminance times the cosine. Witness: an independent GGX in double
// (tests/draw).
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

// The same with the report's BRDF. Witness: its closed form at 60 degrees and head on (tests/draw).
vec3 direct_phong(Phong p, vec3 N, vec3 V, Arrival a)
{
    Real NL = dot(N, a.direction);
    vec3 f = brdf_phong(p, N, V, select(NL > 0.0, a.direction, N));
    return select(NL > 0.0, (NL * f) * a.illuminance, vec3(0.0));
}

// Whether light from L may make a highlight that is narrower than what the surface mirrors within the pixel, so that one
// look through the middle may miss it, or take it for all of the pixel. A lobe of roughness alpha is about 2 alpha wide
// in mirrored directions; of two numbers the smaller says how narrow it is, the larger how far it reaches. Witness: both sides
// of either bound.
Mask hides_highlight(ShinyPoint s, vec2 alpha, vec3 L)
{
    Real turn2 = dot(s.mirrored_dx, s.mirrored_dx) + dot(s.mirrored_dy, s.mirrored_dy);
    vec3 off = mirrored(s.normal, s.view) - L;
    Real reach = sqrt(turn2) + 6.0 * max(alpha.x, alpha.y);
    Real narrow = min(alpha.x, alpha.y);
    return turn2 > narrow * narrow && dot(off, off) < reach * reach;
}

// The normal at look i of 64 in the pixel, eight by eight: for a viewer who does not move, the one that mirrors as the surface
// does there. Nothing mirrored goes below the horizon: a pixel at a rim is wider than what is seen of the surface in it.
// Witness: its mirrored directions have the pixel's middle and variance.
vec3 normal_of_look(ShinyPoint s, int i)
{
    Real x = 0.125 * Real(i % 8) - 0.4375;
    Real y = 0.125 * Real(i / 8) - 0.4375;
    vec3 way = mirrored(s.normal, s.view) + x * s.mirrored_dx + y * s.mirrored_dy;
    return normalize(s.view + normalize(way + max(-dot(s.normal, way), 0.0) * s.normal));
}

// A material whose lobe is as wide as its own and so much of a pixel together. Witness: alpha_in_pixel's.
Metallic widened(Metallic m, vec3 mirrored_dx, vec3 mirrored_dy)
{
    Metallic wide = m;
    wide.alpha = vec2(alpha_in_pixel(m.alpha.x, mirrored_dx, mirrored_dy));
    if (has_stretch() != 0)
        wide.alpha.y = alpha_in_pixel(m.alpha.y, mirrored_dx, mirrored_dy);
    return wide;
}

// direct_metallic averaged over the pixel: by one look at a lobe that is as wide as lobe and pixel, or where that hides a
// highlight by 64 looks, each of an eighth of the width. Witness: quadrature over the pixel.
vec3 direct_metallic_in_pixel(Metallic m, vec2 albedo, ShinyPoint s, Arrival a)
{
    vec3 once = direct_metallic(widened(m, s.mirrored_dx, s.mirrored_dy), albedo, s.normal, s.view, a);
    Mask hidden = hides_highlight(s, m.alpha, a.direction);
    if (any_of(hidden)) {
        Metallic narrow = widened(m, 0.125 * s.mirrored_dx, 0.125 * s.mirrored_dy);
        vec3 sum = vec3(0.0);
        // In fours: some software devices end all loops after 65535 rounds together, which a thousand lights would use up.
        for (int i = 0; i < 64; i += 4)
            sum += direct_metallic(narrow, albedo, normal_of_look(s, i), s.view, a) +
                   direct_metallic(narrow, albedo, normal_of_look(s, i + 1), s.view, a) +
                   direct_metallic(narrow, albedo, normal_of_look(s, i + 2), s.view, a) +
                   direct_metallic(narrow, albedo, normal_of_look(s, i + 3), s.view, a);
        once = select(hidden, 0.015625 * sum, once);
    }
    return once;
}

// The same of direct_phong; its lobe is widened for the 64 looks alone. Witness: as before.
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
