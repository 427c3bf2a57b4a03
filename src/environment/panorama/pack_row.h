// A row of texels packed on SIMD lanes.
#pragma once

#include <cstdint>

namespace lambent::environment {

/// Packs `count` RGB texels, multiplied by `factor`. Values must be finite and not negative.
void pack_row(const float* rgb, int count, float factor, std::uint32_t* texels);

} // namespace lambent::environment
