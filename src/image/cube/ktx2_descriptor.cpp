#include "image/cube/ktx2_descriptor.h"

#include "image/cube/cube_texels.h"

#include <bit>

namespace lambent::image {
namespace {

// Bits of a texel that hold a channel or a channel's exponent.
struct Sample {
    std::uint32_t bit = 0, bits = 0; ///< first bit, number of bits
    std::uint32_t channel = 0;       ///< with its qualifiers
    std::uint32_t lower = 0, upper = 0;
};

constexpr std::uint32_t alpha_channel = 15;
constexpr std::uint32_t is_exponent = 0x20, is_signed = 0x40, is_float = 0x80;

// Consecutive channels with the range -1 to 1.
std::vector<Sample> float_samples(std::uint32_t bits)
{
    const auto one = std::bit_cast<std::uint32_t>(1.0f), minus_one = std::bit_cast<std::uint32_t>(-1.0f);
    std::vector<Sample> samples;
    for (std::uint32_t i = 0; i < 4; ++i)
        samples.push_back(
            {i * bits, bits, (i < 3 ? i : alpha_channel) | is_signed | is_float, minus_one, one});
    return samples;
}

// Each channel has its mantissa and the shared exponent. The exponent's lower limit is its bias, its upper limit
// the largest exponent; the mantissa's upper limit is the one that Khronos's tools write for this format.
std::vector<Sample> shared_exponent_samples()
{
    std::vector<Sample> samples;
    for (std::uint32_t i = 0; i < 3; ++i) {
        samples.push_back({9 * i, 9, i, 0, 8448});
        samples.push_back({27, 5, i | is_exponent, 15, 31});
    }
    return samples;
}

std::vector<Sample> samples_of(TexelFormat format)
{
    switch (format) {
    case TexelFormat::half4:
        return float_samples(16);
    case TexelFormat::float4:
        return float_samples(32);
    case TexelFormat::rgb9e5:
        break;
    }
    return shared_exponent_samples();
}

} // namespace

Ktx2Format ktx2_format(TexelFormat format)
{
    switch (format) {
    case TexelFormat::half4:
        return {97, 2}; // VK_FORMAT_R16G16B16A16_SFLOAT
    case TexelFormat::float4:
        return {109, 4}; // VK_FORMAT_R32G32B32A32_SFLOAT
    case TexelFormat::rgb9e5:
        break;
    }
    return {123, 4}; // VK_FORMAT_E5B9G9R9_UFLOAT_PACK32
}

std::vector<std::uint8_t> ktx2_descriptor(TexelFormat format)
{
    constexpr std::uint32_t version_1_3 = 2, rgbsda = 1, bt709 = 1, linear = 1;
    const std::vector<Sample> samples = samples_of(format);
    const auto block_bytes = static_cast<std::uint32_t>(24 + 16 * samples.size());
    std::vector<std::uint8_t> bytes;
    append(bytes, block_bytes + 4);
    append(bytes, 0u); // Khronos, basic block
    append(bytes, version_1_3 | block_bytes << 16);
    append(bytes, rgbsda | bt709 << 8 | linear << 16);
    append(bytes, 0u); // blocks of one texel
    append(bytes, static_cast<std::uint32_t>(texel_bytes(format)));
    append(bytes, 0u); // no other planes
    for (const Sample& sample : samples) {
        append(bytes, sample.bit | (sample.bits - 1) << 16 | sample.channel << 24);
        append(bytes, 0u); // sample positions
        append(bytes, sample.lower);
        append(bytes, sample.upper);
    }
    return bytes;
}

} // namespace lambent::image
