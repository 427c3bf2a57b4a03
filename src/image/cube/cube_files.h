// Writes cube maps as KTX 2 and DDS files. For images of their faces, see cube_map.h and image_io.h.
#pragma once

#include "image/cube/cube_map.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lambent::image {

/// How a texel is stored. Values are clamped to the range of the format and NaN becomes 0; only float4 stores
/// every value unchanged.
enum class TexelFormat {
    half4,  ///< four half floats, alpha 1; rounded to nearest even, at most 65504
    float4, ///< four floats, alpha 1
    rgb9e5, ///< three 9-bit mantissas under a 5-bit exponent; 0 to 65408
};

struct Ktx2Options {
    TexelFormat format = TexelFormat::half4;
    bool zstd = false; ///< levels compressed by Zstandard

    /// Keys and values in UTF-8, values without a final zero. KTXorientation is always "rd", the only one
    /// allowed for cube maps; KTXwriter is "lambent" by default.
    std::map<std::string, std::string> metadata;
};

/// Whether this build has libzstd.
bool can_write_zstd();

/// The bytes of a KTX 2 file [Khronos, KTX File Format Specification 2.0.4].
/// Throws Error(usage) as check_cube_map, for metadata that the format forbids, and for Zstandard without libzstd.
std::vector<std::uint8_t> encode_ktx2(const CubeMap& map, const Ktx2Options& options = {});

/// The bytes of a DDS file with the Direct3D 10 header. Throws Error(usage) as check_cube_map.
std::vector<std::uint8_t> encode_dds(const CubeMap& map, TexelFormat format = TexelFormat::half4);

/// Write the same to files, never a partial one. Also throw Error(cannot_write).
void write_ktx2(const CubeMap& map, const Ktx2Options& options, const std::filesystem::path& path);
void write_dds(const CubeMap& map, TexelFormat format, const std::filesystem::path& path);

} // namespace lambent::image
