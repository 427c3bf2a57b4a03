// The studio from the description in its header, a softbox from the solid angle of a rectangle.
#include "environment/builtin/studio.h"

#include "environment/builtin/softbox.h"
#include "tests/environment/light_sums.h"

#include <gtest/gtest.h>

namespace lambent::environment {
namespace {

using testing::luminance;
using testing::pi;
using testing::Vec;

const Vec six_normals[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

TEST(Studio, IsPositiveAndMeetsItselfAtTheSeamAndThePoles)
{
    const image::RadianceImage studio = make_studio(512);
    const int last = studio.width - 1;
    for (const float value : studio.values)
        ASSERT_TRUE(std::isfinite(value) && value > 0.0f);
    // Across the seam no row changes more than it does somewhere else.
    for (int y = 0; y < studio.height; ++y) {
        double most = 0.0;
        for (int x = 0; x < last; ++x)
            most =
                std::max(most, std::fabs(luminance(studio.pixel(x, y)) - luminance(studio.pixel(x + 1, y))));
        ASSERT_LE(std::fabs(luminance(studio.pixel(0, y)) - luminance(studio.pixel(last, y))), most) << y;
    }
    for (int x = 0; x < studio.width / 2; ++x)
        for (const int y : {0, studio.height - 1}) {
            const double here = luminance(studio.pixel(x, y));
            const double across = luminance(studio.pixel(x + studio.width / 2, y));
            ASSERT_NEAR(here / across, 1.0, 0.02) << "column " << x << ", row " << y;
        }
}

TEST(Studio, LightsStandWhereTheHeaderSays)
{
    const image::RadianceImage studio = make_studio(512);
    const float* key = testing::texel_towards(studio, {-1.2, 1.4, 1.2});
    EXPECT_GT(luminance(key), 10.0);
    EXPECT_GT(key[0], 1.1f * key[2]);
    const float* strip = testing::texel_towards(studio, {1.9, 0.55, 0.5});
    EXPECT_GT(luminance(strip), 8.0);
    EXPECT_LT(strip[0], strip[2]);
    const Vec brightest = testing::brightest_direction(studio);
    EXPECT_LT(brightest[2], -0.3) << "the rim light is behind";
    EXPECT_GT(brightest[1], 0.3);
    // The key is the light that matters: no side is lit as well as its. Only the top, which all lights reach, may be.
    const double from_key = testing::irradiance(studio, testing::normalized({-1.2, 1.4, 1.2}));
    for (const Vec& normal : six_normals) {
        if (normal[1] > 0.0)
            continue;
        EXPECT_LT(testing::irradiance(studio, normal), from_key);
    }
    EXPECT_LT(luminance(testing::texel_towards(studio, {0.0, -0.3, -1.0})), 0.5) << "the room is dark";
}

TEST(Studio, LightsTheSameAtAnyWidth)
{
    const image::RadianceImage fine = make_studio(1024);
    double worst = 0.0;
    for (const int width : {64, 128, 256, 512}) {
        const image::RadianceImage coarse = make_studio(width);
        for (const Vec& normal : six_normals) {
            const double error =
                testing::irradiance(coarse, normal) / testing::irradiance(fine, normal) - 1.0;
            worst = std::max(worst, std::fabs(error));
            EXPECT_NEAR(error, 0.0, width < 256 ? 0.03 : 0.01) << width;
        }
    }
    std::printf("worst difference of irradiance to that at width 1024: %.2f %%\n", 100.0 * worst);
}

Softbox plain_box(const glm::vec3& centre, const glm::vec2& half_size)
{
    return {centre, half_size, 0.0f, 0.0f, glm::vec3(1.0f), 1.0f, 0.0f};
}

double shining_solid_angle(const PlacedSoftbox& box, int width)
{
    double sum = 0.0;
    for (int y = 0; y < width / 2; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec d = testing::texel_direction(width, width / 2, x, y);
            const glm::vec3 light =
                box.over(glm::vec3(0.0f), glm::vec3(d[0], d[1], d[2]), static_cast<float>(2.0 * pi / width));
            sum += static_cast<double>(light.g) * testing::texel_area(width, width / 2, y);
        }
    return sum;
}

TEST(Softbox, CoversTheSolidAngleOfItsRectangle)
{
    const glm::vec3 centres[] = {
        {0.0f, 0.0f, 2.0f}, {-1.2f, 1.4f, 1.2f}, {0.0f, 1.5f, 0.0f}, {0.1f, -2.0f, 0.0f}};
    for (const glm::vec3& centre : centres)
        for (const glm::vec2 half :
             {glm::vec2(0.75f, 0.75f), glm::vec2(0.18f, 1.1f), glm::vec2(3.0f, 2.0f)}) {
            const double d2 = static_cast<double>(glm::dot(centre, centre));
            const double a = static_cast<double>(half.x), b = static_cast<double>(half.y);
            const double expected = 4.0 * std::asin(a * b / std::sqrt((a * a + d2) * (b * b + d2)));
            EXPECT_NEAR(shining_solid_angle(PlacedSoftbox(plain_box(centre, half)), 512) / expected, 1.0,
                        0.01);
        }
}

TEST(Softbox, IsUprightUnlessRolled)
{
    Softbox box = plain_box({0.0f, 0.0f, 2.0f}, {0.2f, 1.0f});
    const glm::vec3 black(0.0f), above = glm::normalize(glm::vec3(0.0f, 0.8f, 2.0f)),
                                 beside = glm::normalize(glm::vec3(0.8f, 0.0f, 2.0f));
    EXPECT_EQ(PlacedSoftbox(box).over(black, above, 0.001f).r, 1.0f);
    EXPECT_LT(PlacedSoftbox(box).over(black, beside, 0.001f).r, 0.02f);
    box.roll = 0.5f * static_cast<float>(pi);
    EXPECT_LT(PlacedSoftbox(box).over(black, above, 0.001f).r, 0.02f);
    EXPECT_EQ(PlacedSoftbox(box).over(black, beside, 0.001f).r, 1.0f);
}

TEST(Softbox, ShinesLessTowardsItsCornersAndHasADarkFrame)
{
    Softbox box = plain_box({0.0f, 0.0f, 2.0f}, {1.0f, 1.0f});
    box.edge = 0.5f;
    box.frame = 0.1f;
    const PlacedSoftbox placed(box);
    const auto at = [&](float x, float y) {
        return placed.over(glm::vec3(0.3f), glm::normalize(glm::vec3(x, y, 2.0f)), 0.001f).r;
    };
    EXPECT_NEAR(at(0.0f, 0.0f), 1.0f, 1e-6f);
    EXPECT_NEAR(at(0.99f, 0.99f), 0.5f, 0.08f);
    EXPECT_LT(at(1.05f, 0.0f), 0.05f);
    EXPECT_EQ(at(1.2f, 0.0f), 0.3f);
    EXPECT_EQ(placed.over(glm::vec3(0.3f), glm::vec3(0.0f, 0.0f, -1.0f), 0.001f).r, 0.3f)
        << "behind the viewer";
}

} // namespace
} // namespace lambent::environment
