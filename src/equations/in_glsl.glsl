// What the text needs beyond GLSL's own types and builtins. Include before all.glsl.
#define Real float
#define Mask bool

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

float select(bool m, float yes, float no) { return m ? yes : no; }
vec3 select(bool m, vec3 yes, vec3 no) { return m ? yes : no; }
