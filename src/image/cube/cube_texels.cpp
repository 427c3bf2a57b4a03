#include "image/cube/cube_texels.h"

#include "image/packed_texel.h"

#include <bit>

namespace lambent::image {
namespace {

template <class Number>
std::uint8_t* put(std::uint8_t* out, Number number)
{
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        *out++ = static_cast<std::uint8_t>(number >> 8 * i);
    return out;
}

std::uint8_t* put_half4(const float* rgb, std::uint8_t* out)
{
    constexpr std::uint16_t one = 0x3c00;
    for (int c = 0; c < 3; ++c)
        out = put(out, to_half(rgb[c]));
    return put(out, one);
}

std::uint8_t* put_float4(const float* rgb, std::uint8_t* out)
{
    for (int c = 0; c < 3; ++c)
        out = put(out, std::bit_cast<std::uint32_t>(rgb[c]));
    return put(out, std::bit_cast<std::uint32_t>(1.0f));
}

std::uint8_t* put_rgb9e5(const float* rgb, std::uint8_t* out)
{
    return put(out, pack_rgb9e5(rgb[0], rgb[1], rgb[2]));
}

template <class Put>
void put_all(std::span<const float> rgb, std::uint8_t* out, Put put_texel)
{
    for (std::size_t i = 0; i + 3 <= rgb.size(); i += 3)
        out = put_texel(rgb.data() + i, out);
}

} // namespace

std::size_t texel_bytes(TexelFormat format)
{
    return format == TexelFormat::half4 ? 8 : format == TexelFormat::float4 ? 16 : 4;
}

std::uint64_t face_bytes(const CubeMap& map, int level, TexelFormat format)
{
    const auto size = static_cast<std::uint64_t>(map.face_size(level));
    return size * size * texel_bytes(format);
}

void append_texels(std::span<const float> rgb, TexelFormat format, std::vector<std::uint8_t>& bytes)
{
    const std::size_t start = bytes.size();
    bytes.resize(start + rgb.size() / 3 * texel_bytes(format));
    std::uint8_t* const out = bytes.data() + start;
    switch (format) {
    case TexelFormat::half4:
        return put_all(rgb, out, put_half4);
    case TexelFormat::float4:
        return put_all(rgb, out, put_float4);
    case TexelFormat::rgb9e5:
        return put_all(rgb, out, put_rgb9e5);
    }
}

} // namespace lambent::image
