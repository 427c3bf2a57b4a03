// light.glsl in C++.
#pragma once

#include <glm/vec4.hpp>

#include <cstddef>

namespace lambent::gpu_layout {

using glm::ivec4, glm::vec4;

#include "gpu_layout/light.glsl"

// std430: vectors of four at multiples of 16 bytes, without gaps.
static_assert(sizeof(PictureRecord) == 96 && offsetof(PictureRecord, fragments) == 64 &&
              offsetof(PictureRecord, samples) == 80);
static_assert(sizeof(LightRecord) == 64 && offsetof(LightRecord, outer) == 48);
static_assert(sizeof(SampleRecord) == 32 && offsetof(SampleRecord, lobe) == 16);
static_assert(sizeof(LampRecord) == 32 && offsetof(LampRecord, light) == 16);

} // namespace lambent::gpu_layout
