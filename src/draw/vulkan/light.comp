#version 460
#extension GL_GOOGLE_include_directive : require
// One pass of light over fragments: which, and by which model, is compiled in.
#include "draw/vulkan/bindings.glsl"
#include "draw/vulkan/hooks.glsl"
#include "shading/all.glsl"

layout(local_size_x = group_size) in;
layout(constant_id = constant_pass) const int pass = pass_specular;
layout(constant_id = constant_model) const int model = model_ggx;
layout(constant_id = constant_levels) const int levels = levels_matched;

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

const int lights_at_once = 1024;
shared vec3 group_points[group_size];
shared vec3 group_low;
shared vec3 group_high;
shared uint reaching[lights_at_once / 32]; // a bit per light

// The box around the points of a group; points that are not there repeat one that is.
void find_box(vec3 point)
{
    uint me = gl_LocalInvocationID.x;
    group_points[me] = point;
    barrier();
    if (me == 0u) {
        group_low = point;
        group_high = point;
        for (int i = 1; i < group_size; ++i) {
            group_low = min(group_low, group_points[i]);
            group_high = max(group_high, group_points[i]);
        }
    }
    barrier();
}

// Whether a light's range does not end before the box.
bool reaches(LightRecord light)
{
    vec3 way = light.position_local.xyz - clamp(light.position_local.xyz, group_low, group_high);
    return light.outer.y < 0.0 || dot(way, way) <= 1.0001 * light.outer.y;
}

// Marks those of the lights from `first` on that can matter to the group.
void find_lights(int first)
{
    int me = int(gl_LocalInvocationID.x);
    if (me < lights_at_once / 32)
        reaching[me] = 0u;
    barrier();
    for (int i = me; i < lights_at_once && first + i < picture.fragments.z; i += group_size)
        if (reaches(lights[first + i]))
            atomicOr(reaching[i / 32], 1u << (i % 32));
    barrier();
}

// A fragment as the direct pass sees it.
struct Receiver {
    ShinyPoint shiny;
    vec3 point;
    Metallic metallic;
    Phong phong;
    vec2 albedo;
};

Receiver receiver_at(uint at)
{
    Metallic m = metallic_at(at);
    ShinyPoint s = ShinyPoint(load3(column_normal, at), load3(column_view, at), load3(column_mirrored_dx, at),
                              load3(column_mirrored_dy, at));
    return Receiver(s, load3(column_position, at), m, phong_at(at), albedo_of(dot(s.normal, s.view), m.alpha));
}

vec3 light_from(Receiver r, LightRecord light)
{
    Arrival arrival = arrival_at(light, r.point);
    if (levels == levels_pipeline) // one look, as the report has it
        return direct_phong(r.phong, r.shiny.normal, r.shiny.view, arrival);
    return model == model_phong ? direct_phong_in_pixel(r.phong, r.shiny, arrival)
                                : direct_metallic_in_pixel(r.metallic, r.albedo, r.shiny, arrival);
}

// For all of a group together: lights out of reach of all of them are passed over.
void add_direct(uint at, bool lit)
{
    Receiver r = receiver_at(min(at, fragment_count() - 1u));
    find_box(r.point);
    vec3 sum = vec3(0.0);
    for (int first = 0; first < picture.fragments.z; first += lights_at_once) {
        find_lights(first);
        for (int i = 0; i < lights_at_once / 32; ++i)
            for (uint marked = reaching[i]; marked != 0u; marked &= marked - 1u)
                sum += light_from(r, lights[first + 32 * i + findLSB(marked)]);
        barrier();
    }
    if (lit)
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
    float brightness = picture.rotation.z * load(column_occlusion, at);
    store3(levels == levels_pipeline ? ambient_report(report_tone(), diffuse, irradiance, brightness)
                                     : ambient_light(diffuse, irradiance, brightness), column_ambient, at);
}

// In the environment's own frame.
ShinyPoint shiny_at(uint at)
{
    return ShinyPoint(turned(load3(column_normal, at)), turned(load3(column_view, at)), turned(load3(column_mirrored_dx, at)),
                      turned(load3(column_mirrored_dy, at)));
}

Mirror mirror_at(uint at)
{
    ShinyPoint s = shiny_at(at);
    float alpha = load(column_gloss, at);
    return Mirror(s, turned(picture.across.xyz), alpha, albedo_of(dot(s.normal, s.view), alpha));
}

vec3 reflected_phong(Environment e, uint at)
{
    ShinyPoint s = shiny_at(at);
    vec3 across = turned(picture.across.xyz);
    Phong p = phong_at(at);
    if (levels == levels_pipeline)
        return specular_pipeline_report(e, report_tone(), p, s.normal, s.view, across);
    if (levels == levels_report)
        return specular_phong_report(e, p, s.normal, s.view, across);
    return specular_phong(e, p, s, across);
}

vec3 reflected_ggx(Environment e, uint at)
{
    Mirror mirror = mirror_at(at);
    LobeLight light = specular_ggx(e, mirror);
    Reflectance r = reflectance_metallic(metallic_at(at), mirror.albedo);
    return r.plain * light.plain + r.grazing * light.grazing;
}

// What these read in the lobe's middle, as a part of the levels that there are.
float middle_level(Environment e, uint at)
{
    float exponent = load(column_gloss, at);
    if (model == model_ggx)
        return part_of_levels(middle_level_ggx(e, mirror_at(at)), float(textureQueryLevels(chain) - 1));
    if (levels == levels_pipeline)
        return part_of_levels(middle_level_pipeline(e, exponent), float(textureQueryLevels(mips) - 1));
    if (levels == levels_report)
        return part_of_levels(middle_level_report(e, exponent), float(textureQueryLevels(mips) - 1));
    return part_of_levels(middle_level_phong(e, shiny_at(at), exponent), float(textureQueryLevels(chain) - 1));
}

void add_specular(uint at)
{
    Environment e = Environment(picture.samples.x, picture.fragments.w);
    store3(model == model_phong ? reflected_phong(e, at) : reflected_ggx(e, at), column_reflected, at);
    if (picture.samples.z > 0) // layers
        store(middle_level(e, at), column_middle_level, at);
}

void main()
{
    uint at = gl_GlobalInvocationID.x;
    bool lit = at < fragment_count() && load(column_lit, at) > 0.0;
    if (pass == pass_direct)
        add_direct(at, lit);
    else if (!lit)
        return;
    else if (pass == pass_ambient)
        add_ambient(at);
    else
        add_specular(at);
}
