// The sun on texels: its light and its place, summed from the texels, against what was asked for.
#include "environment/sky/sun_disc.h"

#include "tests/environment/light_sums.h"

#include <gtest/gtest.h>

namespace lambent::environment {
namespace {

using testing::degree;
using testing::pi;
using testing::Vec;

constexpr double radius = 0.265 * degree;

image::RadianceImage black(int width)
{
    return {width, width / 2, 3, std::vector<float>(static_cast<std::size_t>(3 * width * (width / 2)))};
}

image::RadianceImage sun_alone(int width, double azimuth, double elevation, double ground_edge = -1.5)
{
    image::RadianceImage image = black(width);
    add_sun({azimuth, elevation, ground_edge, {3.0f, 2.0f, 0.5f}}, image);
    return image;
}

// Calls visit(rgb, direction, solid angle) for the texels that are not black.
template <class Visit>
void for_each_lit_texel(const image::RadianceImage& image, Visit&& visit)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (image.pixel(x, y)[1] > 0.0f)
                visit(image.pixel(x, y), testing::texel_direction(image.width, image.height, x, y),
                      testing::texel_area(image.width, image.height, y));
}

struct Measured {
    Vec light{}; // red, green, blue
    Vec centroid{};
};

Measured measure(const image::RadianceImage& image)
{
    Measured m;
    for_each_lit_texel(image, [&](const float* rgb, const Vec& d, double area) {
        for (std::size_t c = 0; c < 3; ++c) {
            m.light[c] += static_cast<double>(rgb[c]) * area;
            m.centroid[c] += static_cast<double>(rgb[1]) * area * d[c];
        }
    });
    m.centroid = testing::normalized(m.centroid);
    return m;
}

Vec direction(double azimuth, double elevation)
{
    return {std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
            std::cos(elevation) * std::sin(azimuth)};
}

double angle(const Vec& a, const Vec& b)
{
    const Vec off = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return 2.0 * std::asin(0.5 * std::sqrt(testing::dot(off, off)));
}

struct Place {
    double azimuth, elevation;
};

// In the middle, at the seam, on both sides of it, at and near the zenith and the horizon.
const Place places[] = {{0.0, 40.0 * degree}, {pi, 0.3},
                        {-pi + 0.003, -0.05}, {0.5, 0.0},
                        {2.0, 80.0 * degree}, {-2.5, 89.0 * degree},
                        {0.7, 89.7 * degree}, {-3.0, 90.0 * degree}};

TEST(SunDisc, KeepsItsLightAndItsPlaceAtAnyWidth)
{
    double worst = 0.0;
    for (const int width : {64, 256, 2048})
        for (const Place& place : places) {
            const image::RadianceImage image = sun_alone(width, place.azimuth, place.elevation);
            const Measured m = measure(image);
            const Vec irradiance = {3.0, 2.0, 0.5};
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(m.light[c] / irradiance[c], 1.0, 1e-5);
            const double texel = 2.0 * pi / width;
            const Vec sun = direction(place.azimuth, place.elevation);
            const double off = angle(m.centroid, sun) / texel;
            worst = std::max(worst, off);
            EXPECT_LT(off, 0.02) << width << ' ' << place.azimuth << ' ' << place.elevation;
            for_each_lit_texel(image, [&](const float*, const Vec& d, double) {
                ASSERT_LT(angle(d, sun), radius + 1.5 * texel) << width;
            });
        }
    std::printf("worst place of the sun: off by %.4f texels\n", worst);
}

// The mean square distance from the middle of a disc that darkens as (1 - r^2)^a is 1 / (a + 2), evenly bright 1 / 2.
// Sharing points between texels adds a sixth of a texel's square along each axis.
TEST(SunDisc, IsADarkeningDisc)
{
    const Vec sun = direction(0.2, 0.0);
    double light = 0.0, second = 0.0;
    for_each_lit_texel(sun_alone(4096, 0.2, 0.0), [&](const float* rgb, const Vec& d, double area) {
        light += static_cast<double>(rgb[1]) * area;
        second += static_cast<double>(rgb[1]) * area * std::pow(angle(d, sun), 2);
    });
    const double texel = 2.0 * pi / 4096.0;
    EXPECT_NEAR((second / light - texel * texel / 3.0) / (radius * radius), 1.0 / 2.254, 0.01);
}

TEST(SunDisc, AtTheZenithIsTheSameInAllColumns)
{
    for (const int width : {64, 128, 256, 512, 1024}) {
        const image::RadianceImage image = sun_alone(width, 1.0, 0.5 * pi);
        for (int x = 0; x < width; ++x)
            ASSERT_NEAR(image.pixel(x, 0)[0] / image.pixel(0, 0)[0], 1.0f, 1e-3f) << width << ' ' << x;
    }
}

// A chord cuts off what the ground hides. Of an evenly bright disc half is left at the middle; the limb is darker.
TEST(SunDisc, IsHiddenBelowTheGroundsEdge)
{
    for (const int width : {128, 1024}) {
        const auto left = [width](double above_edge) {
            return measure(sun_alone(width, 0.4, -0.01 + above_edge, -0.01)).light[1] / 2.0;
        };
        EXPECT_NEAR(left(0.0), 0.5, 0.02);
        EXPECT_NEAR(left(1.01 * radius), 1.0, 1e-5);
        EXPECT_EQ(left(-1.01 * radius), 0.0);
        // Of the area of a disc, a chord half-way leaves 0.8045; weighted by (1 - r^2)^a, strips are
        // (1 - x^2)^(a + 1/2) strong.
        double above = 0.0, all = 0.0;
        for (int i = 0; i < 4000; ++i) {
            const double x = (i + 0.5) / 2000.0 - 1.0, strip = std::pow(1.0 - x * x, 0.754);
            all += strip;
            above += x < 0.5 ? strip : 0.0;
        }
        EXPECT_NEAR(left(0.5 * radius), above / all, 0.02);
    }
}

TEST(SunDisc, AddsToWhatIsThere)
{
    image::RadianceImage image = black(64);
    for (float& value : image.values)
        value = 0.25f;
    add_sun({0.3, 0.5, 0.0, {1.0f, 1.0f, 1.0f}}, image);
    EXPECT_NEAR(measure(image).light[0], 1.0 + 0.25 * 4.0 * pi, 1e-5);
}

} // namespace
} // namespace lambent::environment
