// Encodes the texels and numbers of cube map files, little-endian on every machine.
#pragma once

#include "image/cube/cube_files.h"

#include <concepts>
#include <span>

namespace lambent::image {

/// Size of a texel in bytes.
std::size_t texel_bytes(TexelFormat format);

/// Size of a face of a level in bytes.
std::uint64_t face_bytes(const CubeMap& map, int level, TexelFormat format);

/// Appends RGB floats as texels of a format.
void append_texels(std::span<const float> rgb, TexelFormat format, std::vector<std::uint8_t>& bytes);

/// Appends an unsigned number, lowest byte first.
template <std::unsigned_integral Number>
void append(std::vector<std::uint8_t>& bytes, Number number)
{
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        bytes.push_back(static_cast<std::uint8_t>(number >> 8 * i));
}

} // namespace lambent::image
