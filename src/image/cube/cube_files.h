// Cube maps as files for renderers: KTX 2 and DDS. Pictures of their faces: cube_map.h and image_io.h.
#pragma once

#include "image/cube/cube_map.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lambent::image {

/// How a texel is stored. Light is cut to what a format holds; NaN becomes 0, but for float4, which keeps
/// everything.
enum class TexelFormat {
    half4,  ///< four half floats, alpha 1; to nearest even, at most 65504
    float4, ///< four floats, alpha 1
    rgb9e5, ///< three 9-bit mantissas under a 5-bit exponent; 0 to 65408
};

struct Ktx2Options {
    TexelFormat format = TexelFormat::half4;
    bool zstd = false; ///< levels compressed by Zstandard

    /// Keys and values for the file, in UTF-8, values without their final zero. KTXorientation is always
    /// "rd", the only one a cube map may have; KTXwriter is "lambent" where it is not given.
    std::map<std::string, std::string> metadata;
};

/// Whether this build has libzstd.
bool can_write_zstd();

/// A KTX 2 file [Khronos, KTX File Format Specification 2.0.4].
/// Throws Error(usage) as check_cube_map, for metadata the format forbids, and for Zstandard without libzstd.
std::vector<std::uint8_t> encode_ktx2(const CubeMap& map, const Ktx2Options& options = {});

/// A DDS file with the header of Direct3D 10. Throws Error(usage) as check_cube_map.
std::vector<std::uint8_t> encode_dds(const CubeMap& map, TexelFormat format = TexelFormat::half4);

/// The same into files, whole or not at all. Throw Error(cannot_write) too.
void write_ktx2(const CubeMap& map, const Ktx2Options& options, const std::filesystem::path& path);
void write_dds(const CubeMap& map, TexelFormat format, const std::filesystem::path& path);

} // namespace lambent::image
