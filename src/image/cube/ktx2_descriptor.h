// What KTX 2 says about a texel format: its number in Vulkan, and where the bits of its channels lie.
#pragma once

#include "image/cube/cube_files.h"

namespace lambent::image {

struct Ktx2Format {
    std::uint32_t vk_format = 0; ///< VkFormat
    std::uint32_t type_size = 0; ///< bytes of what would be swapped on a big-endian machine
};
Ktx2Format ktx2_format(TexelFormat format);

/// A data format descriptor with one basic block, its total size first [Khronos, Data Format Specification
/// 1.3, 5 "The Khronos Basic Data Format Descriptor Block"]. The same whether levels are compressed or not.
std::vector<std::uint8_t> ktx2_descriptor(TexelFormat format);

} // namespace lambent::image
