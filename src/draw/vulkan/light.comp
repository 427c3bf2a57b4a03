#version 460
#extension GL_GOOGLE_include_directive : require
// One light pass over fragments; pass and model are specialisation constants.
#include "draw/vulkan/bindings.glsl"
#include "draw/vulkan/hooks.glsl"

layout(local_size_x = group_size) in;
layout(constant_id = constant_pass) const int pass = pass_specular;
layout(constant_id = constant_layered) const int layered = 1;
layout(constant_id = constant_model) const int model = model_ggx;
layout(constant_id = constant_levels) const int levels = levels_matched;

int has_layers() { return layered; }
int model_of(Environment e) { return model; }
int levels_of(Environment e) { return levels; }

#include "shading/all.glsl"
#include "shading/light_passes.glsl"
#include "shading/ray_pass.glsl" // not used yet: devices trace no rays

Arrival arrival_at(LightRecord light, vec3 point)
{
    LocalLight local = LocalLight(light.position_local.xyz, light.intensity_range.xyz, light.axis_inner.xyz,
                                  light.intensity_range.w, light.axis_inner.w, light.outer.x);
    return arrival_of(local, int(light.position_local.w), point);
}

const int lights_at_once = 1024;
shared vec3 group_points[group_size];
shared vec3 group_low;
shared vec3 group_high;
shared uint reaching[lights_at_once / 32]; // a bit per light

// The bounding box of the points of a workgroup. Invocations beyond the last fragment repeat its point.
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

// Whether a light's range reaches the box.
bool reaches(LightRecord light)
{
    vec3 way = light.position_local.xyz - clamp(light.position_local.xyz, group_low, group_high);
    return light.outer.y < 0.0 || dot(way, way) <= 1.0001 * light.outer.y;
}

// Marks those of the lights from `first` on that can reach the workgroup.
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

// All invocations of a workgroup take part: lights that reach none of their points are skipped.
void add_direct(Environment e, uint at, bool lit)
{
    Fragment f = Fragment(min(at, fragment_count() - 1u));
    Receiver r = receiver_at(e, f);
    find_box(r.point);
    vec3 sum = vec3(0.0);
    for (int first = 0; first < picture.fragments.z; first += lights_at_once) {
        find_lights(first);
        for (int i = 0; i < lights_at_once / 32; ++i)
            for (uint marked = reaching[i]; marked != 0u; marked &= marked - 1u)
                sum += direct_light(e, r, arrival_at(lights[first + 32 * i + findLSB(marked)], r.point));
        barrier();
    }
    if (lit)
        store3(Fragment(at), column_direct, sum);
}

void main()
{
    uint at = gl_GlobalInvocationID.x;
    Fragment f = Fragment(at);
    bool there = at < fragment_count();
    bool few = there && records[at].place.z < small_share;
    Environment e = Environment(few ? picture.samples.w : picture.samples.x, few ? picture.samples.x : 0, picture.fragments.w);
    bool lit = there && load(f, column_lit) > 0.0;
    if (pass == pass_direct)
        add_direct(e, at, lit);
    else if (!lit)
        return;
    else if (pass == pass_ambient)
        add_ambient(e, f);
    else {
        add_specular(e, f);
        if (picture.samples.z > 0) // layers
            store(f, column_middle_level, middle_level(e, f));
    }
}
