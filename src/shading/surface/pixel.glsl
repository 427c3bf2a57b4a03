// The directions that a glossy surface mirrors within a pixel. Needs no hooks.

// A surface point: shading normal, direction to the viewer, with dot(normal, view) > 0, and the changes of the mirrored
// direction to the next pixel right and below.
struct ShinyPoint {
    vec3 normal;
    vec3 view;
    vec3 mirrored_dx;
    vec3 mirrored_dy;
};

// alpha of the lobe together with the surface's curvature within a pixel: a highlight smaller than a pixel becomes
// larger and dimmer instead of flickering. The differentials are those of the mirrored direction, which turns twice
// as far as the normal; a box of width w has variance w^2 / 12. [Tokuyoshi and Kaplanyan 2019, "Improved geometric
// specular antialiasing", JCGT 10(2): alpha^2 + 2 variance of slopes]
// Witness: the variance of slopes in a box (tests/equations).
Real alpha_in_pixel(Real alpha, vec3 mirrored_dx, vec3 mirrored_dy)
{
    Real bend2 = 0.25 * (dot(mirrored_dx, mirrored_dx) + dot(mirrored_dy, mirrored_dy));
    return min(sqrt(alpha * alpha + bend2 * 0.08333333333333333), 1.0);
}

// A pixel's footprint on the sphere of mirrored directions: their centre, and their density as a Gaussian with the
// variance of a pixel, 1/12. Dot products with `right` and `down` give the position in the pixel; size: solid angle
// of the pixel.
struct Footprint {
    vec3 middle;
    vec3 right;
    vec3 down;
    Real size;
};

// The footprint of a pixel at a surface point. Witness: that of density_in_pixel.
Footprint footprint_of(ShinyPoint s)
{
    vec3 area = cross(s.mirrored_dx, s.mirrored_dy);
    Real size2 = dot(area, area);
    Real inverse = 1.0 / max(size2, 1.0e-30);
    Footprint f = {mirrored(s.normal, s.view), inverse * cross(s.mirrored_dy, area),
                   inverse * cross(area, s.mirrored_dx), sqrt(size2)};
    return f;
}

// Density per solid angle of direction L in the footprint.
// Witness: quadrature gives 1 and the variance (tests/equations).
Real density_in_pixel(Footprint f, vec3 L)
{
    Real x = dot(L, f.right);
    Real y = dot(L, f.down);
    Real density = 1.909859317102744 * exp2(-8.656170245333781 * min(x * x + y * y, 12.0)) / max(f.size, 1.0e-15);
    return select(dot(L, f.middle) > 0.0, density, 0.0);
}

// A pixel's contribution to a lobe's samples: the part of the pixel over which they are spread, the variance of the
// blur common to all, in square radians, and how much wider the pixel is than the lobe, 0 to 1.
struct PixelBlur {
    Real moved;
    Real variance;
    Real share;
};

// If the lobe is wider than the pixel in all directions, moving samples within the pixel would only tear gaps into
// their spiral: they stay at the centre, and the pixel's variance, a twelfth of its area, goes into the blur.
// lobe_variance: of the blur of the sample at the lobe's centre. per_sample is 1 / N.
// Witness: positions and blurs together have the pixel's variance (tests/equations).
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
