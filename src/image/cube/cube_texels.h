// Texels of cube map files, and numbers in them: little-endian, whatever the machine.
#pragma once

#include "image/cube/cube_files.h"

#include <concepts>
#include <span>

namespace lambent::image {

/// Bytes of a texel.
std::size_t texel_bytes(TexelFormat format);

/// Bytes of one face of a level.
std::uint64_t face_bytes(const CubeMap& map, int level, TexelFormat format);

/// Appends the texels of RGB floats.
void append_texels(std::span<const float> rgb, TexelFormat format, std::vector<std::uint8_t>& bytes);

/// Appends an unsigned number, its lowest byte first.
template <std::unsigned_integral Number>
void append(std::vector<std::uint8_t>& bytes, Number number)
{
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        bytes.push_back(static_cast<std::uint8_t>(number >> 8 * i));
}

} // namespace lambent::image
