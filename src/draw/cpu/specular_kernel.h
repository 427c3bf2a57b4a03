// Specular light of the environment, in SIMD lanes: a pass of src/shading over the fragments of a tile. In a file of its
// own, because it takes the compiler longer than all other light.
#pragma once

#include "draw/cpu/fragments.h"
#include "draw/light_context.h"

#include <cstddef>

namespace lambent::draw {

/// Fills column_reflected: the environment's specular light; with `middle_level`, also that column.
void light_specularly(const LightContext& context, std::size_t begin, std::size_t end, Fragments& fragments);

} // namespace lambent::draw
