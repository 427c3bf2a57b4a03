// The bindings of the passes, and small functions that read them.
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "shading/numbers.glsl"
#include "gpu_layout/light.glsl"
#include "gpu_layout/scene.glsl"
#include "gpu_layout/tile.glsl"
#include "equations/in_glsl.glsl"
#include "equations/all.glsl"

// Raster shaders define ONLY_READS, because not every device allows them to write.
#ifdef ONLY_READS
#define WRITTEN readonly
#else
#define WRITTEN
#endif

layout(std430, set = 0, binding = binding_fragments) WRITTEN buffer Fragments { float values[]; };
layout(std430, set = 0, binding = binding_picture) readonly buffer Picture { PictureRecord picture; };
layout(std430, set = 0, binding = binding_lights) readonly buffer Lights { LightRecord lights[]; };
layout(std430, set = 0, binding = binding_samples) readonly buffer Samples { SampleRecord samples[]; };
layout(std430, set = 0, binding = binding_lamps) readonly buffer Lamps { LampRecord lamps[]; };
layout(std430, set = 0, binding = binding_albedo) readonly buffer Albedo { vec2 albedos[]; };
layout(std430, set = 0, binding = binding_instances) readonly buffer Instances { InstanceRecord instances[]; };
layout(std430, set = 0, binding = binding_meshes) readonly buffer Meshes { MeshRecord meshes[]; };
layout(std430, set = 0, binding = binding_materials) readonly buffer Materials { MaterialRecord materials[]; };
layout(std430, set = 0, binding = binding_textures) readonly buffer Textures { TextureRecord textures[]; };
layout(std430, set = 0, binding = binding_codes) readonly buffer Codes { float code_light[]; };
layout(std430, set = 0, binding = binding_places) readonly buffer Places { vec2 places[]; };
layout(std430, set = 0, binding = binding_seen) WRITTEN buffer Seen { uvec4 seen[]; };
layout(std430, set = 0, binding = binding_records) WRITTEN buffer Records { FragmentRecord records[]; };
layout(std430, set = 0, binding = binding_spans) WRITTEN buffer Spans { uvec4 spans[]; }; // first, count, background
layout(std430, set = 0, binding = binding_behind) WRITTEN buffer Behind { vec4 behind[]; }; // distance, weight, extent
layout(std430, set = 0, binding = binding_counters) WRITTEN buffer Counters { uint counters[]; };
layout(std430, set = 0, binding = binding_listed) WRITTEN buffer Listed { uint listed[]; };
layout(std430, set = 0, binding = binding_output) WRITTEN buffer Output { vec4 drawn[]; }; // [layer][pixel of the tile]
layout(set = 0, binding = binding_chain) uniform samplerCube chain;
layout(set = 0, binding = binding_irradiance) uniform samplerCube irradiance_map;
layout(set = 0, binding = binding_mips) uniform sampler2D mips;
layout(set = 0, binding = binding_ids) uniform usampler2DArray ids;

layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer Words { uint words[]; };

uint fragment_count() { return min(counters[counter_fragments], uint(picture.fragments.x)); }

uint column_place(int column, uint at) { return uint(column) * uint(picture.fragments.x) + at; }

// Hooks of src/shading/README.md.
struct Fragment {
    uint at;
};

float load(Fragment f, int column) { return values[column_place(column, f.at)]; }
#ifndef ONLY_READS
void store(Fragment f, int column, float v) { values[column_place(column, f.at)] = v; }

#include "shading/passes/vectors.glsl"

// Reserves `count` fragments. Returns the index of the first, which may be beyond the capacity.
uint add_fragments(uint count)
{
    uint first = atomicAdd(counters[counter_fragments], count);
    uint groups = (min(first + count, uint(picture.fragments.x)) + uint(group_size) - 1u) / uint(group_size);
    atomicMax(counters[counter_fragment_groups], groups);
    return first;
}

// The same for pixels listed for gather.comp.
uint add_listed(uint count)
{
    uint first = atomicAdd(counters[counter_listed], count);
    atomicMax(counters[counter_listed_groups],
              (first + count + uint(group_size_of_looks) - 1u) / uint(group_size_of_looks));
    return first;
}
#endif

float albedo_entry(float column, float row, int part) { return albedos[picture.samples.y * int(row) + int(column)][part]; }
