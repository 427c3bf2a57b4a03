#include "image/cube/cube_files.h"

#include "base/file.h"
#include "image/cube/cube_texels.h"

#include <initializer_list>

namespace lambent::image {
namespace {

// Constants named as in Microsoft's dds.h and dxgiformat.h.
constexpr std::uint32_t ddsd_caps = 0x1, ddsd_height = 0x2, ddsd_width = 0x4, ddsd_pitch = 0x8;
constexpr std::uint32_t ddsd_pixelformat = 0x1000, ddsd_mipmapcount = 0x20000;
constexpr std::uint32_t ddpf_fourcc = 0x4;
constexpr std::uint32_t ddscaps_complex = 0x8, ddscaps_texture = 0x1000, ddscaps_mipmap = 0x400000;
constexpr std::uint32_t ddscaps2_cubemap_all_faces = 0xfe00;
constexpr std::uint32_t dimension_texture2d = 3, misc_texturecube = 0x4;
constexpr std::uint32_t alpha_mode_opaque = 3;

constexpr std::uint32_t four_characters(const char (&name)[5])
{
    std::uint32_t code = 0;
    for (std::uint32_t i = 0; i < 4; ++i)
        code |= static_cast<std::uint32_t>(static_cast<unsigned char>(name[i])) << 8 * i;
    return code;
}

std::uint32_t dxgi_format(TexelFormat format)
{
    constexpr std::uint32_t r32g32b32a32_float = 2, r16g16b16a16_float = 10, r9g9b9e5_sharedexp = 67;
    return format == TexelFormat::half4    ? r16g16b16a16_float
           : format == TexelFormat::float4 ? r32g32b32a32_float
                                           : r9g9b9e5_sharedexp;
}

void append_all(std::vector<std::uint8_t>& bytes, std::initializer_list<std::uint32_t> words)
{
    for (const std::uint32_t word : words)
        append(bytes, word);
}

void append_header(std::vector<std::uint8_t>& bytes, const CubeMap& map, TexelFormat format)
{
    const auto size = static_cast<std::uint32_t>(map.size), levels = static_cast<std::uint32_t>(map.levels);
    const auto pitch = static_cast<std::uint32_t>(size * texel_bytes(format));
    const bool chain = levels > 1;
    append(bytes, four_characters("DDS "));
    append_all(bytes, {124,
                       ddsd_caps | ddsd_height | ddsd_width | ddsd_pitch | ddsd_pixelformat |
                           (chain ? ddsd_mipmapcount : 0),
                       size, size, pitch, 0, levels});
    append_all(bytes, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    append_all(bytes, {32, ddpf_fourcc, four_characters("DX10"), 0, 0, 0, 0, 0});
    append_all(bytes, {ddscaps_complex | ddscaps_texture | (chain ? ddscaps_mipmap : 0),
                       ddscaps2_cubemap_all_faces, 0, 0, 0});
    // The array size of a cube map is the number of cubes.
    append_all(bytes, {dxgi_format(format), dimension_texture2d, misc_texturecube, 1, alpha_mode_opaque});
}

} // namespace

std::vector<std::uint8_t> encode_dds(const CubeMap& map, TexelFormat format)
{
    check_cube_map(map);
    constexpr std::size_t header_bytes = 148;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(header_bytes + map.values.size() / 3 * texel_bytes(format));
    append_header(bytes, map, format);
    for (int face = 0; face < 6; ++face)
        for (int level = 0; level < map.levels; ++level)
            append_texels(map.face(level, face), format, bytes);
    return bytes;
}

void write_dds(const CubeMap& map, TexelFormat format, const std::filesystem::path& path)
{
    check_can_write(path);
    write_file(path, encode_dds(map, format));
}

} // namespace lambent::image
