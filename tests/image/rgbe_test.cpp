// The RGBE pixel against the C library's ldexp.
#include "image/radiance/rgbe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace lambent::image {
namespace {

double value_of(int mantissa, int exponent)
{
    return exponent == 0 ? 0.0 : std::ldexp(static_cast<double>(mantissa), exponent - 136);
}

TEST(Rgbe, decodes_every_mantissa_and_exponent_exactly)
{
    std::vector<std::uint8_t> planes(4 * 65536);
    std::vector<Rgbe> pixels(65536);
    for (std::size_t i = 0; i < 65536; ++i) {
        const auto m = static_cast<std::uint8_t>(i & 255), e = static_cast<std::uint8_t>(i >> 8);
        pixels[i] = {m, static_cast<std::uint8_t>(255 - m), static_cast<std::uint8_t>(m ^ 85), e};
        for (std::size_t c = 0; c < 4; ++c)
            planes[c * 65536 + i] = pixels[i][c];
    }
    std::vector<float> from_planes(3 * 65536), from_pixels(3 * 65536);
    planes_to_rgb(planes.data(), 65536, {1, 1, 1}, from_planes.data());
    pixels_to_rgb(pixels.data(), 65536, {1, 1, 1}, from_pixels.data());
    for (std::size_t i = 0; i < 65536; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_EQ(from_planes[3 * i + c], value_of(pixels[i][c], pixels[i][3])) << i;
            ASSERT_EQ(from_pixels[3 * i + c], value_of(pixels[i][c], pixels[i][3])) << i;
        }
}

TEST(Rgbe, scales_each_channel)
{
    const std::uint8_t planes[] = {200, 100, 50, 136};
    float rgb[3];
    planes_to_rgb(planes, 1, {0.5f, 2.0f, 4.0f}, rgb);
    EXPECT_EQ(rgb[0], 100.0f);
    EXPECT_EQ(rgb[1], 200.0f);
    EXPECT_EQ(rgb[2], 200.0f);
}

TEST(Rgbe, gives_back_the_codes_of_every_normalised_pixel)
{
    for (int e = 1; e < 256; ++e)
        for (int m = 128; m < 256; ++m) {
            const Rgbe codes =
                to_rgbe(static_cast<float>(value_of(m, e)), static_cast<float>(value_of(m / 2, e)),
                        static_cast<float>(value_of(255 - m, e)));
            ASSERT_EQ(codes, (Rgbe{static_cast<std::uint8_t>(m), static_cast<std::uint8_t>(m / 2),
                                   static_cast<std::uint8_t>(255 - m), static_cast<std::uint8_t>(e)}));
        }
}

TEST(Rgbe, rounds_to_the_nearest_code)
{
    std::minstd_rand random(3);
    std::uniform_real_distribution<double> exponent(-100, 100), other(0, 1);
    for (int i = 0; i < 100000; ++i) {
        const double largest = std::exp2(exponent(random));
        const float rgb[] = {static_cast<float>(largest * other(random)), static_cast<float>(largest),
                             static_cast<float>(largest * other(random))};
        const Rgbe codes = to_rgbe(rgb[0], rgb[1], rgb[2]);
        ASSERT_GE(*std::max_element(codes.begin(), codes.begin() + 3), 128);
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_LE(std::abs(value_of(codes[c], codes[3]) - double{rgb[c]}), value_of(1, codes[3]) / 2)
                << rgb[0] << " " << rgb[1] << " " << rgb[2];
    }
}

TEST(Rgbe, carries_into_the_exponent)
{
    EXPECT_EQ(to_rgbe(255.4f, 0, 0), (Rgbe{255, 0, 0, 136}));
    EXPECT_EQ(to_rgbe(255.5f, 100, 0), (Rgbe{128, 50, 0, 137}));
    EXPECT_EQ(to_rgbe(1, 1, 1), (Rgbe{128, 128, 128, 129}));
}

TEST(Rgbe, has_a_code_for_what_cannot_be_held)
{
    const float infinity = std::numeric_limits<float>::infinity(),
                nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(to_rgbe(-1, 2, -infinity), (Rgbe{0, 128, 0, 130}));
    EXPECT_EQ(to_rgbe(nan, 2, 0), (Rgbe{0, 128, 0, 130}));
    EXPECT_EQ(to_rgbe(nan, nan, nan), (Rgbe{0, 0, 0, 0}));
    EXPECT_EQ(to_rgbe(infinity, 0, 0), (Rgbe{255, 0, 0, 255}));
    EXPECT_EQ(to_rgbe(std::numeric_limits<float>::max(), 0x1p126f, 0), (Rgbe{255, 128, 0, 255}));
    EXPECT_EQ(to_rgbe(0, 0, 0), (Rgbe{0, 0, 0, 0}));
    EXPECT_EQ(to_rgbe(0x1p-129f, 0x1p-140f, 0), (Rgbe{0, 0, 0, 0}));
    EXPECT_EQ(to_rgbe(0x1p-128f, 0, 0), (Rgbe{128, 0, 0, 1}));
}

} // namespace
} // namespace lambent::image
