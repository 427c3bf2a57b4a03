// This folder's GLSL files compiled as C++.
#pragma once

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>

namespace lambent::gpu_layout {

using glm::ivec4, glm::uvec4, glm::vec4;
using uint = std::uint32_t;

#include "shading/numbers.glsl"

#include "gpu_layout/bake.glsl"
#include "gpu_layout/light.glsl"
#include "gpu_layout/scene.glsl"
#include "gpu_layout/tile.glsl"

// The layout of std430: four-component vectors start at multiples of 16 bytes, and there is no padding.
static_assert(sizeof(LightRecord) == 64 && offsetof(LightRecord, outer) == 48);
static_assert(sizeof(SampleRecord) == 32 && offsetof(SampleRecord, lobe) == 16);
static_assert(sizeof(LampRecord) == 32 && offsetof(LampRecord, light) == 16);
static_assert(sizeof(InstanceRecord) == 112 + 4 * texture_room && offsetof(InstanceRecord, sets) == 112);
static_assert(sizeof(MeshRecord) == 32 && sizeof(UseRecord) == 48);
static_assert(offsetof(MaterialRecord, phong_diffuse) == 4 * (parameter_room + texture_room));
static_assert(offsetof(MaterialRecord, uses) ==
              offsetof(MaterialRecord, phong_diffuse) + 80 + 4 * texture_room);
static_assert(sizeof(MaterialRecord) == offsetof(MaterialRecord, uses) + texture_count * sizeof(UseRecord));
static_assert(sizeof(TextureRecord) == 288 && offsetof(TextureRecord, levels) == 32);
static_assert(sizeof(PictureRecord) == 432 && offsetof(PictureRecord, layers) == 368);
static_assert(sizeof(PictureRecord::layers) == most_layers * sizeof(int));
static_assert(sizeof(FragmentRecord) == 32 && sizeof(RasterConstants) == 80);
static_assert(sizeof(BakeConstants) == 32);

} // namespace lambent::gpu_layout
