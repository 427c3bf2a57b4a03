// Small floating point formats against their definitions in double, and against OpenEXR's half.
#include "image/packed_texel.h"

#include <gtest/gtest.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lambent::image {
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

// The encoding as EXT_texture_shared_exponent writes it down, in double, where all its steps are exact.
std::uint32_t packed_by_the_book(const float (&rgb)[3])
{
    double c[3];
    for (int k = 0; k < 3; ++k)
        c[k] = std::clamp<double>(rgb[k], 0.0, 511.0 / 512.0 * 65536.0);
    const double largest = std::max({c[0], c[1], c[2]});
    int exponent = 0;
    std::frexp(largest, &exponent); // 2^(exponent - 1) <= largest < 2^exponent
    int shared = largest > 0.0 ? std::max(-16, exponent - 1) + 16 : 0;
    if (std::floor(std::ldexp(largest, 24 - shared) + 0.5) == 512.0)
        ++shared;
    std::uint32_t texel = static_cast<std::uint32_t>(shared) << 27;
    for (int k = 0; k < 3; ++k)
        texel |= static_cast<std::uint32_t>(std::floor(std::ldexp(c[k], 24 - shared) + 0.5)) << 9 * k;
    return texel;
}

TEST(PackedTexel, Rgb9e5IsRoundedByTheBook)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> exponent(-30.0f, 16.5f);
    for (int i = 0; i < 200000; ++i) {
        const float c[3] = {std::exp2(exponent(random)), std::exp2(exponent(random)), 0.0f};
        ASSERT_EQ(pack_rgb9e5(c[0], c[1], c[2]), packed_by_the_book(c)) << c[0] << " " << c[1];
    }
    // Halfway between two codes, and the floats beside it.
    for (int step = 0; step < 512; ++step) {
        const float middle = std::ldexp(static_cast<float>(step) + 0.5f, -8);
        for (float value : {std::nextafter(middle, 0.0f), middle, std::nextafter(middle, 9.0f)}) {
            const float beside[3] = {1.75f, value, 0.0f};
            ASSERT_EQ(pack_rgb9e5(1.75f, value, 0.0f), packed_by_the_book(beside)) << value;
        }
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
    EXPECT_EQ(to_half(-1e30f), 0xfbff);
    EXPECT_EQ(to_half(INFINITY), 0x7bff);
    EXPECT_EQ(to_half(std::nanf("")), 0);
    EXPECT_EQ(to_half(-1.0f), 0xbc00);
}

// Ties included, which go to the even neighbour.
TEST(PackedTexel, HalfsRoundAsOpenExrRounds)
{
    for (std::uint16_t low = 0; low < 0x7bff; ++low) {
        const float middle = 0.5f * (from_half(low) + from_half(static_cast<std::uint16_t>(low + 1)));
        for (float value : {std::nextafter(middle, 0.0f), middle, std::nextafter(middle, 1e9f)}) {
            ASSERT_EQ(to_half(value), half(value).bits()) << value;
            ASSERT_EQ(to_half(-value), half(-value).bits()) << value;
        }
    }
}

} // namespace
} // namespace lambent::image
