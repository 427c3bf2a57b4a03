#include "environment/cube_chain.h"

#include <numbers>

namespace lambent::environment {

void CubeChain::allocate(int log2_face_size, int level_count)
{
    log2_size = log2_face_size;
    levels = level_count;
    const std::size_t pitch = static_cast<std::size_t>(face_size(0)) + 2;
    const std::size_t texels = level_start(log2_size) + 6 * pitch * pitch;
    // A pair of texels is read as eight halfs, the last two of which may lie behind the last texel.
    halfs.assign(3 * texels + 8, 0);
}

float level_one_deviation(const CubeChain& chain)
{
    // One texel of level 1, taken as the right angle of a face over its texels.
    return static_cast<float>(std::numbers::pi / 2.0) / static_cast<float>(chain.face_size(1));
}

} // namespace lambent::environment
