#include "environment/chain/cube_chain.h"

#include <new>
#include <numbers>

namespace lambent::environment {

void CubeChain::allocate(int log2_face_size, int level_count)
{
    log2_size = log2_face_size;
    levels = level_count;
    // Memory from calloc is committed only where it is written to: the gaps between levels take none.
    halfs_.reset(static_cast<std::uint16_t*>(std::calloc(3 * end() + 8, sizeof(std::uint16_t))));
    if (!halfs_)
        throw std::bad_alloc();
}

float level_one_deviation(const CubeChain& chain)
{
    // The mean angle of one texel of level 1: the right angle that a face spans over its texels.
    return static_cast<float>(std::numbers::pi / 2.0) / static_cast<float>(chain.face_size(1));
}

} // namespace lambent::environment
