#include "environment/chain/cube_chain.h"

#include <new>
#include <numbers>

namespace lambent::environment {

void CubeChain::allocate(int log2_face_size, int level_count)
{
    log2_size = log2_face_size;
    levels = level_count;
    // Memory from calloc is given only where it is written to.
    halfs_.reset(static_cast<std::uint16_t*>(std::calloc(3 * end() + 8, sizeof(std::uint16_t))));
    if (!halfs_)
        throw std::bad_alloc();
}

float level_one_deviation(const CubeChain& chain)
{
    // One texel of level 1, taken as the right angle of a face over its texels.
    return static_cast<float>(std::numbers::pi / 2.0) / static_cast<float>(chain.face_size(1));
}

} // namespace lambent::environment
