// Codes against the formulas of the report and of the standards, worked out in double.
#include "display/display.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lambent::display {
namespace {

image::RadianceImage grey_ramp()
{
    image::RadianceImage image{300, 1, 4, {}};
    for (int x = 0; x < image.width; ++x) {
        const float light = std::exp2(static_cast<float>(x) / 15.0f - 12.0f); // 2^-12 to 2^8
        image.values.insert(image.values.end(), {light, 0.5f * light, 2.0f * light, 1.0f});
    }
    return image;
}

// Codes may differ by one where the exact value lies within 1e-3 of the middle between two.
void expect_code(std::uint8_t code, double exact)
{
    EXPECT_LE(std::fabs(code - exact * 255.0), 0.5 + 1e-3) << exact;
}

double srgb(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

TEST(Display, ReinhardIsTheReportsFormula)
{
    const image::RadianceImage light = grey_ramp();
    for (float e : {0.1f, 1.0f, 70.0f, 7000.0f})
        for (float k : {0.7f, 1.0f, 1.5f}) {
            const image::CodeImage codes = to_codes(light, {.exposure = e, .contrast = k});
            const image::CodeImage raw = to_codes(light, {.exposure = e, .contrast = k, .encode = false});
            for (std::size_t x = 0; x < 300; ++x)
                for (std::size_t c = 0; c < 3; ++c) {
                    const double ec = static_cast<double>(e) * static_cast<double>(light.values[4 * x + c]);
                    expect_code(codes.bytes[3 * x + c],
                                std::pow(ec / (ec + 1.0), static_cast<double>(k) / 2.2));
                    expect_code(raw.bytes[3 * x + c], std::pow(ec / (ec + 1.0), static_cast<double>(k)));
                }
        }
}

TEST(Display, LinearIsExactSrgb)
{
    const image::RadianceImage light = grey_ramp();
    const image::CodeImage codes = to_codes(light, {.tone = Tone::linear});
    for (std::size_t x = 0; x < 300; ++x)
        for (std::size_t c = 0; c < 3; ++c)
            expect_code(codes.bytes[3 * x + c],
                        srgb(std::min(static_cast<double>(light.values[4 * x + c]), 1.0)));
}

TEST(Display, EveryCurveRisesFromBlackToWhite)
{
    for (Tone tone : {Tone::reinhard, Tone::neutral, Tone::aces, Tone::agx, Tone::linear}) {
        image::RadianceImage image{1000, 1, 3, {}};
        for (int x = 0; x < 1000; ++x)
            image.values.insert(image.values.end(), 3,
                                x == 0 ? 0.0f : std::exp2(static_cast<float>(x) / 40.0f - 12.0f));
        const image::CodeImage codes = to_codes(image, {.tone = tone});
        EXPECT_LE(codes.bytes[0], 1) << static_cast<int>(tone);
        EXPECT_GE(codes.bytes.back(), 250) << static_cast<int>(tone);
        for (std::size_t i = 3; i < codes.bytes.size(); ++i)
            ASSERT_GE(codes.bytes[i], codes.bytes[i - 3]) << static_cast<int>(tone);
    }
}

TEST(Display, NoLightIsUnshowable)
{
    constexpr float infinity = std::numeric_limits<float>::infinity(),
                    nan = std::numeric_limits<float>::quiet_NaN();
    const image::RadianceImage image{2, 1, 3, {nan, infinity, -1.0f, 3.0e38f, -infinity, 1.0e-40f}};
    for (Tone tone : {Tone::reinhard, Tone::neutral, Tone::aces, Tone::agx, Tone::linear})
        for (float e : {1.0e-6f, 1.0f, 1.0e30f}) {
            const image::CodeImage codes = to_codes(image, {.exposure = e, .tone = tone});
            ASSERT_EQ(codes.bytes.size(), 6u);
        }
    const image::CodeImage codes = to_codes(image, {});
    EXPECT_EQ(codes.bytes[0], 0);
    EXPECT_EQ(codes.bytes[1], 255);
    EXPECT_EQ(codes.bytes[2], 0);
    EXPECT_EQ(codes.bytes[3], 255);
}

TEST(Display, DitherKeepsTheMeanAndRepeats)
{
    // A light between two codes: with noise the mean of the codes is the exact value, without it is off.
    image::RadianceImage image{256, 256, 3, std::vector<float>(256 * 256 * 3, 0.3f)};
    const double exact = std::pow(0.3 / 1.3, 1.0 / 2.2) * 255.0;
    const image::CodeImage plain = to_codes(image, {}), noisy = to_codes(image, {.dither = true});
    double mean = 0.0;
    for (const std::uint8_t code : noisy.bytes)
        mean += code / static_cast<double>(noisy.bytes.size());
    EXPECT_NEAR(mean, exact, 0.02);
    EXPECT_EQ(plain.bytes.front(), plain.bytes.back());
    EXPECT_EQ(noisy.bytes, to_codes(image, {.dither = true}).bytes);
    EXPECT_NE(noisy.bytes, plain.bytes);
    // As high as pictures may be.
    const image::RadianceImage tower{1, 65536, 3, std::vector<float>(65536 * 3, 0.3f)};
    EXPECT_NE(to_codes(tower, {.dither = true}).bytes, to_codes(tower, {}).bytes);
}

} // namespace
} // namespace lambent::display
