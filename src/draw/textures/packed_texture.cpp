#include "draw/textures/packed_texture.h"

#include "draw/textures/mask_coverage.h"
#include "environment/panorama/packed_texel.h"
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

// Tables between 8-bit codes and linear light. Encoding quantises light to 16 bits, in steps of 1/20 code in the dark.
struct CodeTables {
    std::array<float, 256> light;
    std::array<std::uint8_t, 65536> code;

    explicit CodeTables(TexelTransfer transfer)
    {
        for (std::size_t i = 0; i < light.size(); ++i)
            light[i] = static_cast<float>(decoded(static_cast<double>(i) / 255.0, transfer));
        // Rounds to the nearest code: code k ends at the light of k + 1/2.
        std::size_t next = 0;
        for (std::size_t k = 0; k < light.size(); ++k)
            for (const double end = decoded((static_cast<double>(k) + 0.5) / 255.0, transfer) * 65535.0;
                 next < code.size() && (k == 255 || static_cast<double>(next) < end); ++next)
                code[next] = static_cast<std::uint8_t>(k);
    }

    std::uint8_t encode(float value) const
    {
        return code[static_cast<std::size_t>(std::clamp(value, 0.0f, 1.0f) * 65535.0f + 0.5f)];
    }
};

// Tables are made on first use: most scenes need that of one transfer and the linear one.
const CodeTables& tables(TexelTransfer transfer)
{
    if (transfer == TexelTransfer::srgb) {
        static const CodeTables srgb(TexelTransfer::srgb);
        return srgb;
    }
    if (transfer == TexelTransfer::power_2_2) {
        static const CodeTables power(TexelTransfer::power_2_2);
        return power;
    }
    static const CodeTables none(TexelTransfer::none);
    return none;
}

// One level without borders, as linear RGBA.
struct LinearLevel {
    int width = 0, height = 0;
    std::vector<float> rgba;

    const float* texel(int x, int y) const
    {
        return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x));
    }
};

// The image as the finest level. Its codes are decoded texel by texel, because a decoded image would be four times as
// large.
struct Source {
    const image::CodeImage& image;
    TexelTransfer transfer;
    const CodeTables &color = tables(transfer), &alpha = tables(TexelTransfer::none);
    int width = image.width, height = image.height;

    std::array<float, 4> texel(int x, int y) const
    {
        const std::size_t first = code_index(x, y);
        std::array<float, 4> rgba;
        for (std::size_t c = 0; c < 4; ++c)
            rgba[c] = image.bits == 8 ? (c == 3 ? alpha : color).light[image.bytes[first + c]]
                                      : decoded_16(first + c, c == 3 ? TexelTransfer::none : transfer);
        return rgba;
    }

    float alpha_at(int x, int y) const
    {
        const std::size_t at = code_index(x, y) + 3;
        return image.bits == 8 ? alpha.light[image.bytes[at]] : decoded_16(at, TexelTransfer::none);
    }

    std::size_t code_index(int x, int y) const
    {
        return 4 *
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    }

private:
    float decoded_16(std::size_t index, TexelTransfer by) const
    {
        std::uint16_t code = 0;
        std::memcpy(&code, image.bytes.data() + 2 * index, 2);
        return static_cast<float>(decoded(code / 65535.0, by));
    }
};

int wrapped(int x, int size, scene::Wrap wrap)
{
    return wrap == scene::Wrap::repeat ? (x + size) % size : std::clamp(x, 0, size - 1);
}

// Colours of a mask are averaged with the weight opaque share + least_share, so that transparent areas keep the mean.
constexpr float least_share = 1.0f / 1024.0f;

// A mask's image as the source of the next level: alpha is the opaque share of each texel, and colours are multiplied
// by their weight.
struct MaskSource {
    const Source& source;
    const scene::Sampler& sampler;
    float least_alpha;
    int width = source.width, height = source.height;

    std::array<float, 4> texel(int x, int y) const
    {
        AlphaAround around;
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i)
                around.alpha[j][i] = source.alpha_at(wrapped(x + i - 1, width, sampler.wrap_u),
                                                     wrapped(y + j - 1, height, sampler.wrap_v));
        std::array<float, 4> rgba = source.texel(x, y);
        rgba[3] = covered_share(around, least_alpha, sampler.magnify_nearest);
        for (std::size_t c = 0; c < 3; ++c)
            rgba[c] *= rgba[3] + least_share;
        return rgba;
    }
};

// The texels of a row that a texel of the next level covers, and their weights: two, or three if the size is odd.
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

template <class Level>
LinearLevel next_level(const Level& from)
{
    LinearLevel to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
    to.rgba.resize(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height) * 4);
    tbb::parallel_for(0, to.height, [&](int y) {
        const Coverage rows = coverage(y, from.height, to.height);
        float* out = to.rgba.data() + 4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(to.width);
        for (int x = 0; x < to.width; ++x, out += 4) {
            const Coverage columns = coverage(x, from.width, to.width);
            for (int j = 0; j < rows.count; ++j)
                for (int i = 0; i < columns.count; ++i) {
                    const auto in = from.texel(columns.first + i, rows.first + j);
                    for (std::size_t c = 0; c < 4; ++c)
                        out[c] += rows.weight[j] * columns.weight[i] * in[c];
                }
        }
    });
    return to;
}

template <class Rgba>
void store_halfs(const Rgba& rgba, std::uint8_t* out)
{
    for (std::size_t c = 0; c < 4; ++c) {
        const std::uint16_t half = environment::to_half(rgba[c]);
        std::memcpy(out + 2 * c, &half, 2);
    }
}

void store_codes(const Source& source, int x, int y, std::uint8_t* out)
{
    std::memcpy(out, source.image.bytes.data() + source.code_index(x, y), 4);
}

// Stores a level and its border, which continues it by the sampler's wrap modes. `store` writes the texel at (x, y).
template <class Store>
void store_level(int index, PackedTexture& texture, const Store& store)
{
    const std::size_t texel_size = texture.half_floats ? 8 : 4;
    const int width = texture.width[index], height = texture.height[index];
    std::uint8_t* const texels =
        texture.bytes.data() + texel_size * static_cast<std::size_t>(texture.start[index]);
    tbb::parallel_for(-1, height + 1, [&](int y) {
        const int row = wrapped(y, height, texture.sampler.wrap_v);
        std::uint8_t* out =
            texels + texel_size * static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(width + 2);
        for (int x = -1; x <= width; ++x, out += texel_size)
            store(wrapped(x, width, texture.sampler.wrap_u), row, out);
    });
}

void store_source(const Source& source, PackedTexture& texture)
{
    if (texture.half_floats)
        store_level(0, texture,
                    [&](int x, int y, std::uint8_t* out) { store_halfs(source.texel(x, y), out); });
    else
        store_level(0, texture, [&](int x, int y, std::uint8_t* out) { store_codes(source, x, y, out); });
}

// `weighed`: colours are multiplied by their weight, which is divided out here.
void store_linear(const LinearLevel& level, bool weighed, int index, const Source& source,
                  PackedTexture& texture)
{
    const auto texel = [&](int x, int y) {
        const float* in = level.texel(x, y);
        const float weight = weighed ? in[3] + least_share : 1.0f;
        return std::array<float, 4>{in[0] / weight, in[1] / weight, in[2] / weight, in[3]};
    };
    const auto encode = [&](int x, int y, std::uint8_t* out) {
        const std::array<float, 4> rgba = texel(x, y);
        for (std::size_t c = 0; c < 4; ++c)
            out[c] = (c == 3 ? source.alpha : source.color).encode(rgba[c]);
    };
    if (texture.half_floats)
        store_level(index, texture, [&](int x, int y, std::uint8_t* out) { store_halfs(texel(x, y), out); });
    else
        store_level(index, texture, encode);
}

} // namespace

const float* code_light(TexelTransfer transfer)
{
    return tables(transfer).light.data();
}

PackedTexture pack_texture(const image::CodeImage& image, const scene::Sampler& sampler,
                           TexelTransfer transfer, std::optional<float> least_alpha)
{
    PackedTexture texture;
    texture.sampler = sampler;
    texture.half_floats = image.bits == 16;
    texture.transfer = transfer;
    texture.light = code_light(transfer);
    texture.alpha = code_light(TexelTransfer::none);
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
    const Source source{image, transfer};
    store_source(source, texture);
    LinearLevel level;
    for (int index = 1; index < texture.levels; ++index) {
        if (index > 1)
            level = next_level(level);
        else
            level = least_alpha ? next_level(MaskSource{source, sampler, *least_alpha}) : next_level(source);
        store_linear(level, least_alpha.has_value(), index, source, texture);
    }
    return texture;
}

} // namespace lambent::draw
