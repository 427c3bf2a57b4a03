#include "equations/in_double.h"

#include <gtest/gtest.h>

namespace lambent::test {
namespace {

using in_double::power;
using in_double::srgb_decode;
using in_double::srgb_encode;
using in_double::vec3;

TEST(Transfer, SrgbPublishedCodes)
{
    // Linear light and the 8-bit code that stands for it, from IEC 61966-2-1's curve: 18% grey is 118, half
    // the light 188, half the code (127.5) 21.4% of the light; 10 is the last whole code on the straight
    // piece.
    struct Code {
        double light;
        int code;
    };
    for (const auto [light, code] :
         {Code{0.0, 0}, Code{0.0003035, 1}, Code{0.0030353, 10}, Code{0.0033465, 11}, Code{0.18, 118},
          Code{0.2158605, 128}, Code{0.5, 188}, Code{1.0, 255}})
        EXPECT_EQ(std::lround(255.0 * srgb_encode(light)), code) << light;
    EXPECT_NEAR(srgb_decode(0.5), 0.21404114, 1e-8);
    EXPECT_NEAR(srgb_encode(0.5), 0.73535698, 1e-8);
    EXPECT_NEAR(srgb_encode(0.18), 0.46135613, 1e-8);
}

TEST(Transfer, SrgbClosedForm)
{
    for (int code = 0; code <= 255; code++) {
        const double c = code / 255.0;
        const double light = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(srgb_decode(c), light, 1e-14);
    }
}

TEST(Transfer, SrgbRoundTrip)
{
    for (int code = 0; code <= 65535; code++)
        EXPECT_NEAR(srgb_encode(srgb_decode(code / 65535.0)), code / 65535.0, 5e-8);
}

TEST(Transfer, SrgbIsContinuousAtTheJoint)
{
    // The standard's own rounded constants leave a step of 3e-8 in code and less in light.
    EXPECT_NEAR(srgb_encode(0.0031308), srgb_encode(std::nextafter(0.0031308, 1.0)), 5e-8);
    EXPECT_NEAR(srgb_decode(0.04045), srgb_decode(std::nextafter(0.04045, 1.0)), 5e-9);
}

TEST(Transfer, SrgbOfAColourIsPerChannel)
{
    const vec3 code = srgb_encode(vec3(0.0, 0.18, 0.5));
    EXPECT_EQ(code.x, 0.0);
    EXPECT_NEAR(code.y, 0.46135613, 1e-8);
    EXPECT_NEAR(code.z, 0.73535698, 1e-8);
}

TEST(Transfer, PowerAgainstTheLibrary)
{
    for (double b : {0.1, 1.0 / 2.4, 0.5, 1.0, 2.2, 3.25})
        for (double a : {1e-12, 1e-3, 0.2, 0.5, 0.999, 1.0})
            EXPECT_NEAR(power(a, b) / std::pow(a, b), 1.0, 1e-13);
}

TEST(Transfer, PowerOfZeroIsZero)
{
    EXPECT_EQ(power(0.0, 2.2), 0.0);
    EXPECT_EQ(power(0.0, 0.01), 0.0);
    const vec3 p = power(vec3(0.0, 0.25, 1.0), 0.5);
    EXPECT_EQ(p.x, 0.0);
    EXPECT_NEAR(p.y, 0.5, 1e-15);
    EXPECT_EQ(p.z, 1.0);
}

} // namespace
} // namespace lambent::test
