// The text of the GGX pass in double over an environment that is dark but for one lamp. Included inside a namespace of
// lambent::in_double that has no name: no guard.

struct Environment {
    vec3 lamp{0.0, 0.0, 1.0};
    vec2 variances{1.0e-6, 4.0e-6}; // of the last level with the lamp and of the first without
};
struct LightSum {};
int sample_count(const Environment&)
{
    return 1;
}
vec3 cap_point(const Environment&, int)
{
    return vec3(0.5, 1.0, 0.0);
}
vec2 pixel_point(const Environment&, int)
{
    return vec2(0.0);
}
Real level_one_variance(const Environment&)
{
    return 1.0;
}
int lamp_count(const Environment&)
{
    return 1;
}
vec3 lamp_direction(const Environment& e, int)
{
    return e.lamp;
}
vec3 lamp_light(const Environment&, int)
{
    return {1.0, 2.0, 3.0};
}
vec2 lamp_variances(const Environment& e)
{
    return e.variances;
}
LightSum no_light(const Environment&)
{
    return {};
}
LightSum with_light(const Environment&, LightSum, vec3, Real, vec2)
{
    return {};
}
vec3 first_light(const Environment&, LightSum)
{
    return vec3(0.0);
}
vec3 second_light(const Environment&, LightSum)
{
    return vec3(0.0);
}

// Whether facets may be stretched.
int stretch = 0;
int has_stretch()
{
    return stretch;
}

// Each test takes some of it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shading/surface/pixel.glsl"
#include "shading/lobes/facets.glsl"
#include "shading/lobes/ggx_light.glsl"
#pragma GCC diagnostic pop
