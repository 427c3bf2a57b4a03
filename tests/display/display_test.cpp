// Codes against the formulas of the report and of the standards, worked out in double.
#include "display/display.h"

#include "equations/in_double.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lambent::display {
namespace {

constexpr Tone all_tones[] = {Tone::reinhard, Tone::neutral, Tone::aces, Tone::agx, Tone::linear};

image::RadianceImage ramp()
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

// All codes side by side, without lighting: as light, and as shares of a pixel that has no other.
image::RadianceImage unlit_codes()
{
    image::RadianceImage image{256, 1, 4, {}};
    for (int code = 0; code < 256; ++code) {
        const auto light = static_cast<float>(in_double::srgb_decode(code / 255.0));
        image.values.insert(image.values.end(), {light, 0.5f * light, 1.0f, 1.0f});
    }
    image.unlit = image.values;
    return image;
}

TEST(Display, UnlitTexelsComeOutAsTheyWentIn)
{
    const image::RadianceImage light = unlit_codes();
    for (const Tone tone : all_tones)
        for (const float exposure : {0.01f, 1.0f, 300.0f})
            for (const float contrast : {0.6f, 1.0f, 2.0f}) {
                const image::CodeImage codes =
                    to_codes(light, {.exposure = exposure, .contrast = contrast, .tone = tone});
                for (std::size_t code = 0; code < 256; ++code) {
                    EXPECT_EQ(codes.bytes[3 * code], code) << static_cast<int>(tone);
                    expect_code(codes.bytes[3 * code + 1],
                                srgb(0.5 * static_cast<double>(light.values[4 * code])));
                    EXPECT_EQ(codes.bytes[3 * code + 2], 255);
                }
            }
    const image::CodeImage raw = to_codes(light, {.exposure = 9.0f, .encode = false});
    const image::CodeImage power = to_codes(light, {.exposure = 9.0f, .unlit_by_power = true});
    for (std::size_t x = 0; x < 256; ++x) {
        const auto value = static_cast<double>(light.values[4 * x]);
        expect_code(raw.bytes[3 * x], value);
        expect_code(power.bytes[3 * x], std::pow(value, 1.0 / 2.2));
    }
}

// A quarter of the pixel shows 0.2 without lighting, the rest is as bright as without it; where the share is 0 nothing is
// different.
TEST(Display, UnlitSharesAreMixedAsLight)
{
    image::RadianceImage mixed{
        2, 1, 4, {0.75f * 0.6f + 0.05f, 0.75f * 3.0f + 0.05f, 0.05f, 1.0f, 0.3f, 0.6f, 2.0f, 1.0f}};
    mixed.unlit = {0.05f, 0.05f, 0.05f, 0.25f, 0.0f, 0.0f, 0.0f, 0.0f};
    image::RadianceImage plain = mixed;
    plain.unlit.clear();
    const double bright[] = {0.6, 3.0, 0.0};
    for (const float exposure : {0.5f, 1.0f}) {
        const image::CodeImage codes = to_codes(mixed, {.exposure = exposure, .tone = Tone::linear});
        for (std::size_t c = 0; c < 3; ++c)
            expect_code(codes.bytes[c],
                        srgb(0.75 * std::min(static_cast<double>(exposure) * bright[c], 1.0) + 0.05));
    }
    for (const Tone tone : all_tones) {
        const image::CodeImage codes = to_codes(mixed, {.tone = tone}),
                               usual = to_codes(plain, {.tone = tone});
        for (std::size_t c = 3; c < 6; ++c)
            EXPECT_EQ(codes.bytes[c], usual.bytes[c]);
    }
}

TEST(Display, ReinhardIsTheReportsFormula)
{
    const image::RadianceImage light = ramp();
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
    const image::RadianceImage light = ramp();
    const image::CodeImage codes = to_codes(light, {.tone = Tone::linear});
    for (std::size_t x = 0; x < 300; ++x)
        for (std::size_t c = 0; c < 3; ++c)
            expect_code(codes.bytes[3 * x + c],
                        srgb(std::min(static_cast<double>(light.values[4 * x + c]), 1.0)));
}

// Colours of every order of channels, pale to pure, from 2^-10 to 2^6.
image::RadianceImage colours()
{
    const float hues[][3] = {{1.0f, 0.8f, 0.6f}, {0.6f, 1.0f, 0.8f},  {0.8f, 0.6f, 1.0f}, {1.0f, 0.3f, 0.5f},
                             {0.5f, 1.0f, 0.3f}, {0.3f, 0.5f, 1.0f},  {1.0f, 0.0f, 0.1f}, {0.1f, 1.0f, 0.0f},
                             {0.0f, 0.1f, 1.0f}, {0.9f, 0.95f, 1.0f}, {0.0f, 0.0f, 1.0f}};
    image::RadianceImage image{0, 1, 3, {}};
    for (int eighth = -80; eighth <= 48; ++eighth)
        for (const auto& hue : hues) {
            for (const float channel : hue)
                image.values.push_back(std::exp2(static_cast<float>(eighth) / 8.0f) * channel);
            ++image.width;
        }
    return image;
}

// The curves themselves have their own witnesses, in tests/equations.
struct Curve {
    Tone tone;
    in_double::vec3 (*apply)(in_double::vec3);
    bool by_power; // 1/2.2 in place of the sRGB curve
};

TEST(Display, ColoursGoThroughCurveContrastAndTransfer)
{
    const image::RadianceImage light = colours();
    for (const Curve& curve : {Curve{Tone::reinhard, in_double::tone_reinhard, true},
                               {Tone::neutral, in_double::tone_neutral, false},
                               {Tone::aces, in_double::tone_aces, false},
                               {Tone::agx, in_double::tone_agx, true},
                               {Tone::linear, in_double::tone_linear, false}})
        for (const float e : {0.5f, 3.0f})
            for (const float k : {0.7f, 1.0f, 1.5f}) {
                const image::CodeImage codes =
                    to_codes(light, {.exposure = e, .contrast = k, .tone = curve.tone});
                const image::CodeImage raw =
                    to_codes(light, {.exposure = e, .contrast = k, .tone = curve.tone, .encode = false});
                ASSERT_EQ(codes.bytes.size(), light.values.size());
                for (std::size_t i = 0; i < light.values.size(); i += 3) {
                    const auto exposed = [&](std::size_t c) {
                        return static_cast<double>(e) * static_cast<double>(light.values[i + c]);
                    };
                    const in_double::vec3 toned = curve.apply({exposed(0), exposed(1), exposed(2)});
                    const double channels[] = {toned.x, toned.y, toned.z};
                    for (std::size_t c = 0; c < 3; ++c) {
                        const double result = std::pow(channels[c], static_cast<double>(k));
                        SCOPED_TRACE(testing::Message()
                                     << "tone " << static_cast<int>(curve.tone) << ", channel " << c << " of "
                                     << exposed(0) << ' ' << exposed(1) << ' ' << exposed(2));
                        expect_code(codes.bytes[i + c],
                                    curve.by_power ? std::pow(result, 1.0 / 2.2) : srgb(result));
                        expect_code(raw.bytes[i + c], result);
                    }
                }
            }
}

TEST(Display, EveryCurveRisesFromBlackToWhite)
{
    for (Tone tone : all_tones) {
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
    const float dark[] = {nan, -nan, -infinity, -1.0f, -3.0e38f, -0.0f, 0.0f},
                bright[] = {infinity, 3.0e38f, 1.0e30f};
    image::RadianceImage image{10, 1, 3, {}};
    for (const float value : dark)
        image.values.insert(image.values.end(), 3, value);
    for (const float value : bright)
        image.values.insert(image.values.end(), 3, value);
    for (Tone tone : all_tones)
        for (float e : {1.0e-6f, 1.0f, 1.0e30f})
            for (const bool encode : {true, false}) {
                const image::CodeImage codes =
                    to_codes(image, {.exposure = e, .tone = tone, .encode = encode});
                ASSERT_EQ(codes.bytes.size(), image.values.size());
                for (std::size_t i = 0; i < 3 * std::size(dark); ++i)
                    EXPECT_EQ(codes.bytes[i], 0) << static_cast<int>(tone) << ' ' << image.values[i];
                for (std::size_t i = 3 * std::size(dark); i < codes.bytes.size(); ++i)
                    EXPECT_GE(codes.bytes[i], 250) << static_cast<int>(tone) << ' ' << image.values[i];
            }
}

// A channel that is no light counts as none and leaves the others as they are.
TEST(Display, ABrokenChannelIsADarkOne)
{
    constexpr float infinity = std::numeric_limits<float>::infinity(),
                    nan = std::numeric_limits<float>::quiet_NaN();
    const image::RadianceImage dark{3, 1, 3, {0.0f, 0.4f, 0.2f, 0.3f, 0.0f, 0.2f, 0.3f, 0.4f, 0.0f}};
    for (Tone tone : all_tones)
        for (const float no_light : {nan, -infinity, -1.0f}) {
            image::RadianceImage broken = dark;
            for (std::size_t i = 0; i < 3; ++i)
                broken.values[4 * i] = no_light;
            EXPECT_EQ(to_codes(broken, {.tone = tone}).bytes, to_codes(dark, {.tone = tone}).bytes)
                << static_cast<int>(tone) << ' ' << no_light;
        }
    const image::RadianceImage image{2, 1, 3, {nan, infinity, -1.0f, 3.0e38f, -infinity, 1.0e-40f}};
    for (Tone tone : {Tone::reinhard, Tone::linear}) // which do not mix channels
        EXPECT_EQ(to_codes(image, {.tone = tone}).bytes, (std::vector<std::uint8_t>{0, 255, 0, 255, 0, 0}));
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

// The sum of two even noises of one code makes the error independent of the light: always a quarter of a code squared,
// a sixth from the noise and a twelfth from rounding.
TEST(Display, DitherIsTriangularNoiseOfOneCode)
{
    constexpr int size = 256;
    for (const float light : {0.02f, 0.3f, 0.31f, 2.0f}) {
        const image::RadianceImage image{size, size, 3, std::vector<float>(size * size * 3, light)};
        const double l = static_cast<double>(light), exact = std::pow(l / (l + 1.0), 1.0 / 2.2) * 255.0;
        const image::CodeImage codes = to_codes(image, {.dither = true});
        double mean = 0.0, variance = 0.0, worst = 0.0;
        double beside = 0.0, below = 0.0, channels = 0.0; // products of neighbours
        const auto error = [&](int x, int y, int c) {
            return codes.bytes[static_cast<std::size_t>(3 * (y % size * size + x % size) + c % 3)] - exact;
        };
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (int c = 0; c < 3; ++c) {
                    const double here = error(x, y, c), share = 1.0 / (3 * size * size);
                    worst = std::max(worst, std::fabs(here));
                    mean += share * here;
                    variance += share * here * here;
                    beside += share * here * error(x + 1, y, c);
                    below += share * here * error(x, y + 1, c);
                    channels += share * here * error(x, y, c + 1);
                }
        EXPECT_LT(worst, 1.5 + 1e-3) << light;
        EXPECT_NEAR(mean, 0.0, 0.01) << light;
        EXPECT_NEAR(variance, 0.25, 0.005) << light;
        EXPECT_NEAR(beside, 0.0, 0.005) << light;
        EXPECT_NEAR(below, 0.0, 0.005) << light;
        EXPECT_NEAR(channels, 0.0, 0.005) << light;
    }
}

TEST(Display, DitherStaysBetweenBlackAndWhite)
{
    image::RadianceImage image{64, 64, 3, std::vector<float>(64 * 64 * 3, 0.0f)};
    for (const std::uint8_t code : to_codes(image, {.dither = true}).bytes)
        ASSERT_LE(code, 1);
    image.values.assign(image.values.size(), 1.0e20f);
    for (const std::uint8_t code : to_codes(image, {.dither = true}).bytes)
        ASSERT_GE(code, 254);
}

} // namespace
} // namespace lambent::display
