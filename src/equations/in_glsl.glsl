// Types and functions that the equations need beyond GLSL's own. Include before all.glsl.
#define Real float
#define Mask bool
#define ONE_BODY

// A number as mantissa * 4^exponent, mantissa in [1, 4).
struct PowersOfFour {
    float mantissa;
    float exponent;
};

PowersOfFour powers_of_four(float a)
{
    float exponent = floor(0.5 * log2(a));
    return PowersOfFour(a * exp2(-2.0 * exponent), exponent);
}

bool any_of(bool m) { return m; }
float select(bool m, float yes, float no) { return m ? yes : no; }
vec3 select(bool m, vec3 yes, vec3 no) { return m ? yes : no; }

// Devices' own functions may have errors of 4096 units in the last place, which moves a panorama by texels; those of
// the polynomials of wide/approximations.h are at most 1.5e-6.
float arc_tangent(float y, float x)
{
    float ratio = min(abs(x), abs(y)) / max(max(abs(x), abs(y)), 1.0e-30);
    float t = ratio * ratio;
    float a = ratio * (0.999999404 + t * (-0.333270133 + t * (0.198873088 + t * (-0.135121241 +
              t * (0.0843530819 + t * (-0.037442077 + t * 0.00800659694))))));
    float octant = abs(y) > abs(x) ? 1.5707963267948966 - a : a;
    float half_plane = x < 0.0 ? 3.141592653589793 - octant : octant;
    return y < 0.0 ? -half_plane : half_plane;
}

float arc_cosine(float a)
{
    float b = abs(a);
    float angle = sqrt(max(1.0 - b, 0.0)) * (1.57079554 + b * (-0.214529768 + b * (0.0880399346 +
                  b * (-0.0454821214 + b * (0.0200193431 - b * 0.00463306624)))));
    return a < 0.0 ? 3.141592653589793 - angle : angle;
}

#define atan arc_tangent
#define acos arc_cosine
