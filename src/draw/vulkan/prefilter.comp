#version 450
#extension GL_GOOGLE_include_directive : require
// The mean over a lobe of the light in a tree of cells, for the 64 directions of a tile: the computation of
// environment/bake/prefilter.cpp, by one workgroup.
#include "gpu_layout/bake.glsl"
#include "equations/in_glsl.glsl"
#include "equations/all.glsl"

layout(local_size_x = 64) in;
layout(constant_id = bake_constant_lobe) const int lobe = bake_lobe_ggx;
layout(push_constant, std430) uniform Constants { BakeConstants bake; };
layout(std430, set = 0, binding = bake_cells) readonly buffer Cells { vec4 cells[]; };
layout(std430, set = 0, binding = bake_bounds) readonly buffer Bounds { vec4 bounds[]; };
layout(std430, set = 0, binding = bake_levels) readonly buffer Levels { ivec4 levels[]; };
layout(std430, set = 0, binding = bake_directions) readonly buffer Directions { vec4 directions[]; };
layout(std430, set = 0, binding = bake_results) writeonly buffer Results { vec4 results[]; };

// A stack of cells to visit, coded as depth, row and column. Of each depth at most 64 are taken at a time, which push
// at most 256 of the next: eight depths (from 4096 columns to the 32 of the top) fill 2048.
const int room = 2112;
const uint none = 0xffffffffu;
shared uint waiting[room];
shared int waiting_count;

// The cells found in a round: up to two per invocation, one for light and one for area.
shared vec4 found_place[128];
shared vec4 found_light[128];
shared uint found[4];  // bits
shared uint bright[4];
shared uint opened[2]; // bits: invocations whose cell was too coarse

shared vec4 points[64];
shared vec4 cap; // the tile's mean direction, and its radius as the length of a chord

uint coded(int depth, int row, int column) { return uint(depth) << 26 | uint(row) << 13 | uint(column); }

void find_cap(vec3 direction)
{
    uint me = gl_LocalInvocationID.x;
    points[me] = vec4(direction, 0.0);
    barrier();
    if (me == 0u) {
        vec3 sum = vec3(0.0);
        for (int i = 0; i < 64; ++i)
            sum += points[i].xyz;
        vec3 middle = sum / max(length(sum), 1.0e-6);
        float radius2 = 0.0;
        for (int i = 0; i < 64; ++i)
            radius2 = max(radius2, dot(points[i].xyz - middle, points[i].xyz - middle));
        cap = vec4(middle, sqrt(radius2));
    }
    barrier();
}

bool beyond(float square, float chord) { return chord < 0.0 || square > chord * chord; }

// Returns 0 for a cell below the horizon of the whole cap, 1 for one that is fine enough, 2 for one that is too coarse.
int judge(int depth, int row, vec4 place, vec4 light)
{
    const float horizon = 1.4142135623730951;
    vec4 bound = bounds[bake.place.y + levels[depth].y + row];
    vec3 way = place.xyz - cap.xyz;
    float square = dot(way, way);
    float reach = cap.w + bound.z;
    if (beyond(square, horizon + reach))
        return 0;
    float far = light.r + light.g + light.b > bake.lobe.z ? bound.y : bound.x;
    bool at_horizon = bound.w == 0.0 && beyond(square, horizon - reach);
    bool fine = !at_horizon && beyond(square, far < 0.0 ? -1.0 : far + cap.w);
    return depth == 0 || fine ? 1 : 2;
}

void put(uint slot, vec4 place, vec4 light, bool is_bright)
{
    found_place[slot] = place;
    found_light[slot] = light;
    atomicOr(found[slot / 32u], 1u << (slot % 32u));
    if (is_bright)
        atomicOr(bright[slot / 32u], 1u << (slot % 32u));
}

// Adds a cell that is fine enough and, if its area is a cell of its own (light.w < 0), that one too.
void take(vec4 place, vec4 light)
{
    uint slot = 2u * gl_LocalInvocationID.x;
    bool own = light.w >= 0.0;
    vec4 area_place = place;
    float area = light.w;
    if (!own) {
        uint at = 2u * uint(-light.w - 0.5);
        area_place = cells[at];
        area = cells[at + 1u].w;
    }
    bool is_bright = light.r + light.g + light.b > bake.lobe.w * area;
    put(slot, place, vec4(light.rgb, own ? area : 0.0), is_bright);
    if (!own)
        put(slot + 1u, area_place, vec4(vec3(0.0), area), is_bright);
}

// Pushes the four children of a coarse cell, next to those of other invocations.
void open(int depth, int row, int column, int bottom)
{
    uint me = gl_LocalInvocationID.x;
    int before = bitCount(opened[0] & (me < 32u ? (1u << me) - 1u : none)) +
                 (me < 32u ? 0 : bitCount(opened[1] & ((1u << (me - 32u)) - 1u)));
    ivec4 finer = levels[depth - 1];
    for (int i = 0; i < 4; ++i) {
        int x = 2 * column + i % 2;
        int y = 2 * row + i / 2;
        waiting[bottom + 4 * before + i] = x < finer.z && y < finer.w ? coded(depth - 1, y, x) : none;
    }
}

// One round: pops up to 64 cells, finds those to be summed, and pushes the children of those that are too coarse.
void look_at_cells()
{
    uint me = gl_LocalInvocationID.x;
    int count = min(waiting_count, 64);
    int bottom = waiting_count - count;
    uint code = int(me) < count ? waiting[bottom + int(me)] : none;
    if (me < 4u) {
        found[me] = 0u;
        bright[me] = 0u;
    }
    if (me < 2u)
        opened[me] = 0u;
    barrier();
    int depth = int(code >> 26);
    int row = int(code >> 13) & 8191;
    int column = int(code) & 8191;
    int judged = 0;
    if (code != none) {
        uint at = 2u * uint(levels[depth].x + row * levels[depth].z + column);
        vec4 place = cells[at];
        vec4 light = cells[at + 1u];
        judged = judge(depth, row, place, light);
        if (judged == 1)
            take(place, light);
        if (judged == 2)
            atomicOr(opened[me / 32u], 1u << (me % 32u));
    }
    barrier();
    if (judged == 2)
        open(depth, row, column, bottom);
    if (me == 0u)
        waiting_count = bottom + 4 * (bitCount(opened[0]) + bitCount(opened[1]));
    barrier();
}

void add_found(vec3 direction, inout LobeSum dim, inout LobeSum bright_sum)
{
    for (int i = 0; i < 4; ++i)
        for (uint marked = found[i]; marked != 0u; marked &= marked - 1u) {
            int bit = findLSB(marked);
            vec4 place = found_place[32 * i + bit];
            vec4 light = found_light[32 * i + bit];
            vec3 way = direction - place.xyz;
            float versine = 0.5 * dot(way, way); // from the chord, accurate for narrow lobes
            float c = 1.0 - versine;
            LobeWeight weight = lobe == bake_lobe_phong ? lobe_weight_phong(c, versine, bake.lobe.x)
                                                        : lobe_weight_ggx(c, versine, bake.lobe.x);
            float w = c > 0.0 ? max(weight.value + place.w * weight.curvature, 0.0) : 0.0;
            if ((bright[i] & (1u << bit)) != 0u) {
                bright_sum.light += w * light.rgb;
                bright_sum.weight += w * light.w;
            } else {
                dim.light += w * light.rgb;
                dim.weight += w * light.w;
            }
        }
}

void main()
{
    uint me = gl_LocalInvocationID.x;
    uint texel = 64u * (uint(bake.place.x) + gl_WorkGroupID.x) + me;
    vec3 direction = directions[texel].xyz;
    find_cap(direction);
    LobeSum dim = LobeSum(vec3(0.0), 0.0);
    LobeSum bright_sum = LobeSum(vec3(0.0), 0.0);
    int top = bake.place.z - 1;
    int tops = levels[top].z * levels[top].w;
    for (int first = 0; first < tops; first += 64) {
        int cell = first + int(me);
        waiting[me] = cell < tops ? coded(top, cell / levels[top].z, cell % levels[top].z) : none;
        if (me == 0u)
            waiting_count = 64;
        barrier();
        while (waiting_count > 0) {
            look_at_cells();
            add_found(direction, dim, bright_sum);
            barrier();
        }
    }
    results[texel] = vec4(mean_of_lobe(dim, bright_sum, bake.lobe.y), 0.0);
}
