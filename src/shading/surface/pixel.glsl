// What a pixel sees of a surface that shines. Needs no hooks.

// Shading normal, direction to the viewer, dot(normal, view) > 0, and how the mirrored direction changes from one pixel to
// the next, to the right and downwards.
struct ShinyPoint {
    vec3 normal;
    vec3 view;
    vec3 mirrored_dx;
    vec3 mirrored_dy;
};

// alpha^2 with the bend of the surface inside a pixel added: a highlight smaller than a pixel is drawn larger and
// dimmer instead of twinkling. The differentials are of the mirrored direction, which turns twice as far as the
// normal; a box of width w has variance w^2 / 12. [Tokuyoshi and Kaplanyan 2019, "Improved geometric specular
// antialiasing", JCGT 10(2): alpha^2 + 2 variance of slopes] Witness: the differentials of a sphere.
Real alpha_in_pixel(Real alpha, vec3 mirrored_dx, vec3 mirrored_dy)
{
    Real bend2 = 0.25 * (dot(mirrored_dx, mirrored_dx) + dot(mirrored_dy, mirrored_dy));
    return min(sqrt(alpha * alpha + bend2 * 0.08333333333333333), 1.0);
}

// How a pixel sees a mirror: the middle of the mirrored directions, and their density over the sphere as a Gaussian of a
// pixel's own variance, a twelfth: `right` and `down` give the place in the pixel, by dot product; size is its solid angle.
struct Footprint {
    vec3 middle;
    vec3 right;
    vec3 down;
    Real size;
};

// Witness: density_in_pixel's.
Footprint footprint_of(ShinyPoint s)
{
    vec3 area = cross(s.mirrored_dx, s.mirrored_dy);
    Real size2 = dot(area, area);
    Real inverse = 1.0 / max(size2, 1.0e-30);
    Footprint f = {mirrored(s.normal, s.view), inverse * cross(s.mirrored_dy, area), inverse * cross(area, s.mirrored_dx),
                   sqrt(size2)};
    return f;
}

// Density per solid angle with which a pixel sees direction L. Witness: quadrature gives 1, and the variance.
Real density_in_pixel(Footprint f, vec3 L)
{
    Real x = dot(L, f.right);
    Real y = dot(L, f.down);
    Real density = 1.909859317102744 * exp2(-8.656170245333781 * min(x * x + y * y, 12.0)) / max(f.size, 1.0e-15);
    return select(dot(L, f.middle) > 0.0, density, 0.0);
}

// What a pixel adds to a lobe's samples: by how much of a pixel they are moved, the variance that all are blurred by, in
// square radians, and how far the pixel is wider than the lobe, 0 to 1.
struct PixelBlur {
    Real moved;
    Real variance;
    Real share;
};

// Where the lobe is the wider in all directions, moving samples about in the pixel only tears gaps into their spiral:
// they stay in the middle, and the blur takes the pixel's variance, a twelfth of its area. lobe_variance: of the blur of
// the sample in the lobe's middle. per_sample is 1 / N. Witness: specular_ggx's.
PixelBlur pixel_blur(ShinyPoint s, Real lobe_variance, Real per_sample)
{
    vec3 area = cross(s.mirrored_dx, s.mirrored_dy);
    Real footprint = sqrt(dot(area, area));
    Real pixel_variance = variance_of_spread(footprint) * per_sample;
    Real longest = dot(s.mirrored_dx, s.mirrored_dx) + dot(s.mirrored_dy, s.mirrored_dy);
    Real widest = variance_of_spread(longest) * per_sample;
    Real moved = widest / max(widest + lobe_variance, 1.0e-30);
    PixelBlur blur = {moved, pixel_variance + (1.0 - moved * moved) * footprint * 0.08333333333333333,
                      pixel_variance / max(pixel_variance + lobe_variance, 1.0e-30)};
    return blur;
}
