// The text of the report's passes in double over an environment that remembers where it was looked at. Included inside a
// namespace of lambent::in_double that has no name: no guard.

// One lookup of the environment.
struct Lookup {
    vec3 direction;
    double level;
};

// An environment that is another colour everywhere and at every level, and remembers where it was looked at.
struct Environment {
    int samples;
    double panorama_width, panorama_height, variance;
    std::vector<Lookup>* lookups;
    int lamps = 0;
    vec3 lamp{0.0, 0.0, 1.0};
};

vec3 radiance(vec3 d, double level)
{
    return vec3(1.0 + d.x, 2.0 + d.y * d.z, 1.0 + 0.5 * level * level);
}

int sample_count(const Environment& e)
{
    return e.samples;
}

// xi2 in equal steps, but not in order.
double xi2_of(const Environment& e, int i)
{
    return (i * 7 % e.samples + 0.5) / e.samples;
}

vec3 lobe_point(const Environment& e, int i)
{
    return vec3(std::log2(xi2_of(e, i)), std::cos(2.4 * i), std::sin(2.4 * i));
}

vec2 pixel_point(const Environment& e, int i)
{
    return {xi2_of(e, i) - 0.5, 0.5 * std::cos(5.0 * i)};
}

Real level_one_variance(const Environment& e)
{
    return e.variance;
}
int lamp_count(const Environment& e)
{
    return e.lamps;
}
vec3 lamp_direction(const Environment& e, int)
{
    return e.lamp;
}
vec3 lamp_light(const Environment&, int)
{
    return {1.0, 2.0, 3.0};
}
vec2 lamp_variances(const Environment&)
{
    return {1.0e-12, 2.0e-12};
}

Real report_base_level(const Environment& e)
{
    return 0.5 * std::log2(e.panorama_width * e.panorama_height);
}

vec3 environment_report_radiance(const Environment& e, vec3 d, Real level)
{
    e.lookups->push_back({d, level});
    return radiance(d, level);
}

vec3 environment_report_texel(const Environment& e, vec3 d, Real level)
{
    return environment_report_radiance(e, d, level);
}

struct LightSum {
    vec3 first, second;
};

LightSum no_light(const Environment&)
{
    return {vec3(0.0), vec3(0.0)};
}

LightSum with_light(const Environment& e, LightSum sum, vec3 d, Real level, vec2 weights)
{
    e.lookups->push_back({d, level});
    return {sum.first + weights.x * radiance(d, level), sum.second + weights.y * radiance(d, level)};
}

vec3 first_light(const Environment&, LightSum sum)
{
    return sum.first;
}
vec3 second_light(const Environment&, LightSum sum)
{
    return sum.second;
}

// Each test takes some of it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shading/lobes/diffuse.glsl"
#include "shading/surface/pixel.glsl"
#include "shading/lobes/phong_light.glsl"
#include "shading/lobes/pipeline_report.glsl"
#pragma GCC diagnostic pop
