// Describes a texel format for KTX 2: its Vulkan format and the bits of its channels.
#pragma once

#include "image/cube/cube_files.h"

namespace lambent::image {

struct Ktx2Format {
    std::uint32_t vk_format = 0; ///< VkFormat
    std::uint32_t type_size = 0; ///< bytes of the unit that a big-endian machine has to swap
};
Ktx2Format ktx2_format(TexelFormat format);

/// A data format descriptor with one basic block, preceded by its total size [Khronos, Data Format Specification
/// 1.3, 5 "The Khronos Basic Data Format Descriptor Block"]. It does not depend on compression.
std::vector<std::uint8_t> ktx2_descriptor(TexelFormat format);

} // namespace lambent::image
