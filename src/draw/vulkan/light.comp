#version 450
#extension GL_GOOGLE_include_directive : require
// One pass of light over fragments: which, and by which model, is compiled in.
#include "gpu_layout/light.glsl"
#include "equations/in_glsl.glsl"
#include "equations/all.glsl"
#include "draw/vulkan/hooks.glsl"
#include "shading/all.glsl"

layout(local_size_x = group_size) in;
layout(constant_id = constant_pass) const int pass = pass_specular;
layout(constant_id = constant_model) const int model = model_ggx;
layout(constant_id = constant_levels) const int levels = levels_matched;

float load(int column, uint at) { return values[uint(column * picture.fragments.x) + at]; }
vec3 load3(int column, uint at) { return vec3(load(column, at), load(column + 1, at), load(column + 2, at)); }

void store3(vec3 v, int column, uint at)
{
    uint first = uint(column * picture.fragments.x) + at;
    uint step = uint(picture.fragments.x);
    values[first] = v.x;
    values[first + step] = v.y;
    values[first + 2 * step] = v.z;
}

// A direction of the world, in the environment's own frame.
vec3 turned(vec3 d)
{
    float c = picture.rotation.x;
    float s = picture.rotation.y;
    return vec3(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}

// The two parts of the directional albedo of GGX, between the table's points.
vec2 albedo_of(float NV, float alpha)
{
    int n = picture.samples.y;
    float x = sqrt(clamp(NV, 0.0, 1.0)) * float(n - 1);
    float y = sqrt(sqrt(clamp(alpha * alpha, 0.0, 1.0))) * float(n - 1);
    int x0 = min(int(x), n - 2);
    int y0 = min(int(y), n - 2);
    int at = y0 * n + x0;
    vec2 above = mix(albedos[at], albedos[at + 1], x - float(x0));
    vec2 below = mix(albedos[at + n], albedos[at + n + 1], x - float(x0));
    return mix(above, below, y - float(y0));
}

Metallic metallic_at(uint at)
{
    return Metallic(load3(column_base, at), load(column_metalness, at), load(column_gloss, at), picture.rotation.w);
}

Phong phong_at(uint at)
{
    return Phong(load3(column_base, at), load3(column_specular, at), load(column_gloss, at));
}

Arrival arrival_at(LightRecord light, vec3 point)
{
    if (light.position_local.w == 0.0)
        return Arrival(-light.axis_inner.xyz, light.intensity_range.xyz);
    LocalLight local = LocalLight(light.position_local.xyz, light.intensity_range.xyz, light.axis_inner.xyz,
                                  light.intensity_range.w, light.axis_inner.w, light.outer.x);
    return arrival_from(local, point);
}

void add_direct(uint at)
{
    vec3 N = load3(column_normal, at);
    vec3 V = load3(column_view, at);
    vec3 point = load3(column_position, at);
    vec3 sum = vec3(0.0);
    if (model == model_phong) {
        Phong p = phong_at(at);
        for (int i = 0; i < picture.fragments.z; ++i)
            sum += direct_phong(p, N, V, arrival_at(lights[i], point));
    } else {
        Metallic m = metallic_at(at);
        vec2 albedo = albedo_of(dot(N, V), m.alpha);
        m.alpha = alpha_in_pixel(m.alpha, load3(column_mirrored_dx, at), load3(column_mirrored_dy, at));
        for (int i = 0; i < picture.fragments.z; ++i)
            sum += direct_metallic(m, albedo, N, V, arrival_at(lights[i], point));
    }
    store3(sum, column_direct, at);
}

void add_ambient(uint at)
{
    vec3 N = load3(column_normal, at);
    vec3 irradiance = picture.maps.x * textureLod(irradiance_map, turned(N), 0.0).rgb;
    vec3 diffuse = load3(column_base, at);
    if (model == model_ggx) {
        Metallic m = metallic_at(at);
        diffuse = reflectance_metallic(m, albedo_of(dot(N, load3(column_view, at)), m.alpha)).diffuse;
    }
    store3(irradiance, column_irradiance, at);
    store3(ambient_light(diffuse, irradiance, picture.rotation.z * load(column_occlusion, at)), column_ambient, at);
}

void add_specular(uint at)
{
    Environment e = Environment(picture.samples.x, picture.fragments.w);
    vec3 N = turned(load3(column_normal, at));
    vec3 V = turned(load3(column_view, at));
    vec3 across = turned(picture.across.xyz);
    if (model == model_phong) {
        Phong p = phong_at(at);
        if (levels == levels_report)
            store3(specular_phong_report(e, p, N, V, across), column_reflected, at);
        else
            store3(specular_phong(e, p, N, V, across), column_reflected, at);
        return;
    }
    Metallic m = metallic_at(at);
    Mirror mirror = Mirror(N, V, across, m.alpha, turned(load3(column_mirrored_dx, at)),
                           turned(load3(column_mirrored_dy, at)), albedo_of(dot(N, V), m.alpha));
    LobeLight light = specular_ggx(e, mirror);
    Reflectance r = reflectance_metallic(m, mirror.albedo);
    store3(r.plain * light.plain + r.grazing * light.grazing, column_reflected, at);
}

void main()
{
    uint at = gl_GlobalInvocationID.x;
    if (at >= uint(picture.fragments.y))
        return;
    if (pass == pass_direct)
        add_direct(at);
    else if (pass == pass_ambient)
        add_ambient(at);
    else
        add_specular(at);
}
