#include "draw/cpu/packed_texture.h"

#include "environment/packed_texel.h"
#include "equations/in_double.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace lambent::draw {
namespace {

double decoded(double code, TexelTransfer transfer)
{
    if (transfer == TexelTransfer::none)
        return code;
    return transfer == TexelTransfer::srgb ? in_double::srgb_decode(code) : in_double::power(code, 2.2);
}

double encoded(double light, TexelTransfer transfer)
{
    if (transfer == TexelTransfer::none)
        return light;
    return transfer == TexelTransfer::srgb ? in_double::srgb_encode(light)
                                           : in_double::power(light, 1.0 / 2.2);
}

// Between 8-bit codes and linear light. Encoding looks up 16-bit light: its steps are a twentieth of a code in the dark.
struct CodeTables {
    std::array<float, 256> light;
    std::vector<std::uint8_t> code;

    explicit CodeTables(TexelTransfer transfer) : code(65536)
    {
        for (std::size_t i = 0; i < light.size(); ++i)
            light[i] = static_cast<float>(decoded(static_cast<double>(i) / 255.0, transfer));
        for (std::size_t i = 0; i < code.size(); ++i)
            code[i] =
                static_cast<std::uint8_t>(encoded(static_cast<double>(i) / 65535.0, transfer) * 255.0 + 0.5);
    }

    std::uint8_t encode(float value) const
    {
        return code[static_cast<std::size_t>(std::clamp(value, 0.0f, 1.0f) * 65535.0f + 0.5f)];
    }
};

const CodeTables& tables(TexelTransfer transfer)
{
    static const CodeTables srgb(TexelTransfer::srgb), power(TexelTransfer::power_2_2),
        none(TexelTransfer::none);
    return transfer == TexelTransfer::srgb ? srgb : transfer == TexelTransfer::power_2_2 ? power : none;
}

// One level without borders, as linear RGBA.
struct LinearLevel {
    int width, height;
    std::vector<float> rgba;
};

LinearLevel decode(const image::CodeImage& image, TexelTransfer transfer)
{
    const std::size_t count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    LinearLevel level{image.width, image.height, std::vector<float>(count)};
    if (image.bits == 8) {
        const CodeTables& color = tables(transfer);
        const CodeTables& alpha = tables(TexelTransfer::none);
        for (std::size_t i = 0; i < count; ++i)
            level.rgba[i] = (i % 4 == 3 ? alpha : color).light[image.bytes[i]];
        return level;
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::uint16_t code = 0;
        std::memcpy(&code, image.bytes.data() + 2 * i, 2);
        level.rgba[i] =
            static_cast<float>(decoded(code / 65535.0, i % 4 == 3 ? TexelTransfer::none : transfer));
    }
    return level;
}

// Which texels of a row of `from` a texel of the next level covers, and how much of each: two, or three if odd.
struct Coverage {
    int first, count;
    float weight[3];
};

Coverage coverage(int texel, int from, int to)
{
    if (from == 1)
        return {0, 1, {1.0f, 0.0f, 0.0f}};
    if (from % 2 == 0)
        return {2 * texel, 2, {0.5f, 0.5f, 0.0f}};
    const float all = static_cast<float>(from), left = static_cast<float>(to - texel) / all;
    const float middle = static_cast<float>(to) / all, right = static_cast<float>(texel + 1) / all;
    return {2 * texel, 3, {left, middle, right}};
}

LinearLevel next_level(const LinearLevel& from)
{
    LinearLevel to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
    to.rgba.resize(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height) * 4);
    tbb::parallel_for(0, to.height, [&](int y) {
        const Coverage rows = coverage(y, from.height, to.height);
        for (int x = 0; x < to.width; ++x) {
            const Coverage columns = coverage(x, from.width, to.width);
            float* out =
                to.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(to.width) +
                                      static_cast<std::size_t>(x));
            for (int j = 0; j < rows.count; ++j)
                for (int i = 0; i < columns.count; ++i) {
                    const float* in = from.rgba.data() + 4 * (static_cast<std::size_t>(rows.first + j) *
                                                                  static_cast<std::size_t>(from.width) +
                                                              static_cast<std::size_t>(columns.first + i));
                    for (int c = 0; c < 4; ++c)
                        out[c] += rows.weight[j] * columns.weight[i] * in[c];
                }
        }
    });
    return to;
}

int wrapped(int x, int size, scene::Wrap wrap)
{
    return wrap == scene::Wrap::repeat ? (x + size) % size : std::clamp(x, 0, size - 1);
}

void store_level(const LinearLevel& level, int index, PackedTexture& texture)
{
    const std::size_t texel_size = texture.half_floats ? 8 : 4;
    const CodeTables& color = tables(texture.transfer);
    const CodeTables& alpha = tables(TexelTransfer::none);
    std::uint8_t* out = texture.bytes.data() + texel_size * static_cast<std::size_t>(texture.start[index]);
    for (int y = -1; y <= level.height; ++y)
        for (int x = -1; x <= level.width; ++x, out += texel_size) {
            const std::size_t row =
                static_cast<std::size_t>(wrapped(y, level.height, texture.sampler.wrap_v));
            const std::size_t column =
                static_cast<std::size_t>(wrapped(x, level.width, texture.sampler.wrap_u));
            const float* in = level.rgba.data() + 4 * (row * static_cast<std::size_t>(level.width) + column);
            for (int c = 0; c < 4; ++c) {
                if (!texture.half_floats) {
                    out[c] = (c == 3 ? alpha : color).encode(in[c]);
                    continue;
                }
                const std::uint16_t half = environment::to_half(in[c]);
                std::memcpy(out + 2 * c, &half, 2);
            }
        }
}

} // namespace

PackedTexture pack_texture(const image::CodeImage& image, const scene::Sampler& sampler,
                           TexelTransfer transfer)
{
    PackedTexture texture;
    texture.sampler = sampler;
    texture.half_floats = image.bits == 16;
    texture.transfer = transfer;
    texture.light = tables(transfer).light.data();
    texture.alpha = tables(TexelTransfer::none).light.data();
    const unsigned longer = static_cast<unsigned>(std::max(image.width, image.height));
    texture.levels = sampler.mipmapped ? static_cast<int>(std::bit_width(longer)) : 1;
    texture.levels = std::min(texture.levels, PackedTexture::most_levels);
    std::int64_t texels = 0;
    int width = image.width, height = image.height;
    for (int level = 0; level < texture.levels; ++level) {
        texture.width[level] = width;
        texture.height[level] = height;
        texture.start[level] = static_cast<std::int32_t>(texels);
        texels += std::int64_t{width + 2} * (height + 2);
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
    }
    texture.bytes.resize(static_cast<std::size_t>(texels) * (texture.half_floats ? 8 : 4) + 16);
    LinearLevel level = decode(image, transfer);
    store_level(level, 0, texture);
    for (int index = 1; index < texture.levels; ++index) {
        level = next_level(level);
        store_level(level, index, texture);
    }
    return texture;
}

} // namespace lambent::draw
