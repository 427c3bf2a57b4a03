#include "environment/kernels.h"
#include "environment/packed_texel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lambent::environment {
namespace {

TEST(PackedTexel, Rgb9e5IsWithinHalfAStepOfTheLargestComponent)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-13.0f, 15.9f), share(0.0f, 1.0f);
    for (int i = 0; i < 100000; ++i) {
        const float largest = std::exp2(exponent(random));
        const float c[3] = {largest, largest * share(random), largest * share(random)};
        const Rgb back = unpack_rgb9e5(pack_rgb9e5(c[0], c[1], c[2]));
        const float unpacked[3] = {back.r, back.g, back.b};
        for (int k = 0; k < 3; ++k)
            ASSERT_LE(std::fabs(unpacked[k] - c[k]), largest * 0x1p-9f * 1.0001f) << c[k];
    }
}

TEST(PackedTexel, Rgb9e5KnownCodes)
{
    // Worked out by hand from the definition: value = mantissa * 2^(exponent - 15 - 9).
    EXPECT_EQ(pack_rgb9e5(1.0f, 0.0f, 0.0f), 16u << 27 | 256u);
    EXPECT_EQ(pack_rgb9e5(0.0f, 0.5f, 0.25f), 15u << 27 | 128u << 18 | 256u << 9);
    EXPECT_EQ(pack_rgb9e5(65408.0f, 65408.0f, 65408.0f), 31u << 27 | 511u << 18 | 511u << 9 | 511u);
    EXPECT_EQ(pack_rgb9e5(1e9f, -3.0f, std::nanf("")), 31u << 27 | 511u);
    EXPECT_EQ(unpack_rgb9e5(16u << 27 | 256u).r, 1.0f);
}

TEST(PackedTexel, RowsArePackedAsSingleTexelsAre)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> exponent(-30.0f, 16.5f);
    for (int count : {1, 7, 16, 31, 100}) {
        std::vector<float> rgb(static_cast<std::size_t>(3 * count));
        for (float& v : rgb)
            v = random() % 8 == 0 ? 0.0f : std::exp2(exponent(random));
        std::vector<std::uint32_t> texels(static_cast<std::size_t>(count));
        pack_row(rgb.data(), count, 0.5f, texels.data());
        for (std::size_t i = 0; i < texels.size(); ++i)
            ASSERT_EQ(texels[i],
                      pack_rgb9e5(rgb[3 * i] * 0.5f, rgb[3 * i + 1] * 0.5f, rgb[3 * i + 2] * 0.5f));
    }
}

// The value of a half by the definition in IEEE 754, in double.
double half_value(std::uint16_t half)
{
    const int exponent = half >> 10 & 31, mantissa = half & 1023;
    const double magnitude =
        exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
    return half & 0x8000 ? -magnitude : magnitude;
}

TEST(PackedTexel, HalfsKeepTheirValue)
{
    for (std::uint32_t half = 0; half < 0x7c00; ++half) {
        ASSERT_EQ(from_half(static_cast<std::uint16_t>(half)), half_value(static_cast<std::uint16_t>(half)));
        ASSERT_EQ(to_half(from_half(static_cast<std::uint16_t>(half))), half);
    }
}

TEST(PackedTexel, HalfsRoundToNearest)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> exponent(-26.0f, 15.99f);
    for (int i = 0; i < 200000; ++i) {
        const float value = std::exp2(exponent(random));
        const std::uint16_t half = to_half(value);
        const double error = std::fabs(half_value(half) - static_cast<double>(value));
        for (int neighbour : {half - 1, half + 1}) {
            if (neighbour < 0 || neighbour >= 0x7c00)
                continue;
            ASSERT_LE(error, std::fabs(half_value(static_cast<std::uint16_t>(neighbour)) - value)) << value;
        }
    }
    EXPECT_EQ(to_half(1e30f), 0x7bff);
    EXPECT_EQ(to_half(std::nanf("")), 0);
    EXPECT_EQ(to_half(-1.0f), 0xbc00);
}

} // namespace
} // namespace lambent::environment
