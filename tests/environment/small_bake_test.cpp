// Baking panoramas that have to be enlarged before: light is kept, and what the bake says of its error is true.
#include "environment/bake/bake.h"
#include "environment/bake/reading_sums.h"
#include "environment/panorama/resized.h"
#include "environment/bake/bake_check.h"
#include "environment/chain/cube_faces.h"
#include "image/panorama_rows.h"
#include "tests/environment/test_panoramas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace lambent::environment {
namespace {

using testing::Vec;

constexpr double pi = std::numbers::pi;

struct Sun {
    int width, height, x, y;
};

// Radiance 1 everywhere but in one texel.
Panorama with_sun(const Sun& sun, float radiance, float around = 1.0f)
{
    image::RadianceImage image{sun.width, sun.height, 3, {}};
    image.values.assign(static_cast<std::size_t>(sun.width * sun.height) * 3, around);
    for (int k = 0; k < 3; ++k)
        image.pixel(sun.x, sun.y)[k] = radiance;
    return make_panorama(image);
}

// GGX about R = N = V, times the cosine, over its integral by quadrature.
class Lobe {
public:
    explicit Lobe(double roughness) : a2_(std::pow(roughness, 4))
    {
        constexpr int steps = 200000;
        for (int i = 0; i < steps; ++i)
            integral_ += 2.0 * pi / steps * weight((i + 0.5) / steps);
    }
    double operator()(double cosine) const { return cosine > 0.0 ? weight(cosine) / integral_ : 0.0; }

private:
    double weight(double cosine) const
    {
        const double q = 0.5 * (1.0 + cosine) * (a2_ - 1.0) + 1.0;
        return cosine / (q * q);
    }

    double a2_, integral_ = 0.0;
};

// The sun as points of light: what is read linearly between texels, a tent along both axes, with a texel's light in all.
// Beyond a pole the tent goes on half a turn away, as the direction does of an angle below 0 or above pi.
struct Point {
    Vec direction;
    double light;
};

std::vector<Point> points_of(const Sun& sun, double radiance)
{
    constexpr int parts = 12;
    std::vector<Point> points;
    double whole = 0.0;
    for (int i = 0; i < parts * parts; ++i) {
        const double u = 2.0 * (i % parts + 0.5) / parts - 1.0,
                     v = 2.0 * (i / parts + 0.5) / parts - 1.0; // NOLINT
        const double theta = (sun.y + 0.5 + v) / sun.height * pi;
        const double weight = (1.0 - std::fabs(u)) * (1.0 - std::fabs(v)) * std::fabs(std::sin(theta));
        points.push_back({testing::texel_direction(sun.width, sun.height, sun.x + u, sun.y + v), weight});
        whole += weight;
    }
    for (Point& point : points)
        point.light *= radiance * testing::texel_area(sun.width, sun.height, sun.y) / whole;
    return points;
}

// Every texel of a level and its light: 1 all around, and the sun.
struct LevelTruth {
    double error = 0.0;                     // relative RMSE of the bake
    double at_brightest = 0.0, there = 0.0; // baked and true
};

LevelTruth compare(const BakedSpecular& baked, int level, const std::vector<Point>& sun)
{
    const Lobe lobe(baked.levels[static_cast<std::size_t>(level)].perceptual_roughness);
    const int size = baked.cube.face_size(level);
    LevelTruth truth;
    double square = 0.0, mean = 0.0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const Direction d =
                    cube_direction(face, (2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0);
                double expected = 1.0;
                for (const Point& point : sun)
                    expected += point.light * lobe(testing::dot({d.x, d.y, d.z}, point.direction));
                const double value = static_cast<double>(baked.cube.pixel(level, face, x, y)[1]);
                square += std::pow(value - expected, 2);
                mean += expected;
                if (expected > truth.there)
                    truth.there = expected, truth.at_brightest = value;
            }
    const double count = 6.0 * size * size;
    truth.error = std::sqrt(square / count) / (mean / count);
    return truth;
}

TEST(SmallBake, ASunOfOneTexelKeepsItsLight)
{
    for (const Sun& sun : {Sun{640, 320, 128, 106},
                           {640, 320, 129, 107},
                           {800, 400, 0, 200},
                           {800, 400, 799, 71},
                           {1000, 500, 333, 401},
                           {1000, 500, 500, 12},
                           {512, 256, 77, 0},
                           {512, 256, 300, 255},
                           {512, 256, 301, 1},
                           {333, 167, 5, 83},
                           {333, 167, 332, 166},
                           {720, 360, 719, 0},
                           {1023, 511, 100, 200},
                           {4096, 256, 1000, 100},
                           {300, 600, 7, 599}}) {
        BakeOptions options;
        options.size = 16;
        options.error = 0.002;
        const Panorama panorama = with_sun(sun, 1e6f);
        const std::vector<Point> points =
            points_of(sun, testing::radiance_of(panorama, sun.x, sun.y, 1) - 1.0);
        const BakedSpecular baked = bake_specular(panorama, options);
        for (const int level : {2, 3}) {
            const LevelTruth truth = compare(baked, level, points);
            const double told = baked.levels[static_cast<std::size_t>(level)].error;
            std::printf("%dx%d, row %d, level %d: brightest %.4f of the truth, error %.3f %%, told %.3f %%\n",
                        sun.width, sun.height, sun.y, level, truth.at_brightest / truth.there,
                        100.0 * truth.error, 100.0 * told);
            EXPECT_NEAR(truth.at_brightest / truth.there, 1.0, 0.003);
            EXPECT_LT(truth.error, 0.003);
            // What is told is of six texels, what is true of all; each has the points of its own.
            EXPECT_GT(told, truth.error / 6.0 - 3e-4);
            EXPECT_LT(told, 6.0 * truth.error + 3e-4);
        }
        double flux = 0.0, known = 4.0 * pi;
        for (const Point& point : points)
            known += point.light;
        for (int face = 0; face < 6; ++face)
            for (int i = 0; i < 256; ++i)
                flux += static_cast<double>(baked.cube.pixel(0, face, i % 16, i / 16)[1]) *
                        cube_texel_solid_angle(16, i % 16, i / 16);
        std::printf("level 0: %.4f of the light\n", flux / known);
        EXPECT_NEAR(flux / known, 1.0, 0.025);
    }
}

// A bake of another panorama is off by what that is off: here a tenth of all light, and of a sun's alone.
TEST(SmallBake, AWrongSunIsToldOf)
{
    const Sun sun{640, 320, 128, 106};
    BakeOptions options;
    options.size = 16;
    const int level = 2;
    for (const bool all : {true, false}) {
        const BakedSpecular baked = bake_specular(with_sun(sun, 1.1e6f, all ? 1.1f : 1.0f), options);
        const std::vector<double> errors = check_levels(with_sun(sun, 1e6f), TexelMeaning::knots, baked.cube,
                                                        {{level, ggx_lobe(std::pow(level / 4.0, 2))}});
        EXPECT_GT(errors[0], 0.09) << all;
        EXPECT_LT(errors[0], 0.25) << all;
    }
}

double light_of(const Panorama& p)
{
    double sum = 0.0;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            sum += testing::radiance_of(p, x, y, 1) * testing::texel_area(p.width, p.height, y);
    return sum;
}

TEST(Resized, EachTexelKeepsItsLight)
{
    for (const Sun& sun : {Sun{64, 32, 5, 0},
                           {64, 32, 63, 31},
                           {64, 32, 0, 1},
                           {50, 25, 49, 12},
                           {7, 5, 3, 0},
                           {2, 1, 1, 0},
                           {3, 3, 0, 2},
                           {640, 320, 128, 106},
                           {100, 500, 99, 0}}) {
        const Panorama lone = with_sun(sun, 100.0f, 0.0f);
        for (const auto& [width, height] : {std::pair(1024, 512), {1000, 700}, {128, 512}}) {
            const double kept =
                light_of(resized(lone, std::max(width, sun.width), std::max(height, sun.height)));
            EXPECT_NEAR(kept / light_of(lone), 1.0, 0.002)
                << sun.width << 'x' << sun.height << ", row " << sun.y << " to " << width << 'x' << height;
        }
    }
}

TEST(Resized, AConstantStaysOne)
{
    for (const Sun& size : {Sun{64, 32, 0, 0}, {2, 1, 0, 0}, {51, 23, 0, 0}, {3, 9, 0, 0}}) {
        const Panorama large = resized(with_sun(size, 0.75f, 0.75f), 200, 100);
        for (int y = 0; y < large.height; ++y)
            for (int x = 0; x < large.width; ++x)
                ASSERT_EQ(large.radiance(x, y).g, 0.75f) << size.width << ": " << x << ", " << y;
    }
}

// Light that grows linearly in a horizontal direction does so across the poles.
TEST(Resized, GoesOnAcrossThePoles)
{
    const int width = 64, height = 16, fine_height = 512;
    const auto expected = [](const Vec& d) { return 2.0 + 0.8 * d[0] - 0.6 * d[2]; };
    const std::vector<double> angles = image::row_angles(height);
    image::RadianceImage image{width, height, 3, {}};
    for (const double angle : angles)
        for (int x = 0; x < width; ++x)
            image.values.insert(image.values.end(), 3,
                                static_cast<float>(expected(
                                    testing::texel_direction(width, height, x, angle / pi * height - 0.5))));
    const Panorama large = resized(make_panorama(image), 2 * fine_height, fine_height);
    constexpr double step = 4.0 / 512.0; // of the texels' numbers, which are rounded before and after
    for (int y = 0; y < fine_height / height / 2; ++y)
        for (const int row : {y, fine_height - 1 - y})
            for (int x = 0; x < large.width; x += 7)
                EXPECT_NEAR(testing::radiance_of(large, x, row, 1),
                            expected(testing::texel_direction(large.width, fine_height, x, row)), 1.2 * step)
                    << x << ", " << row;
}

// Points between the texels see what the enlarged panorama's texels are the means of.
TEST(SumReading, IsTheLightOfTheTexels)
{
    for (const Sun& sun :
         {Sun{64, 32, 5, 0}, {64, 32, 40, 20}, {50, 25, 49, 24}, {7, 5, 3, 2}, {2, 1, 1, 0}}) {
        // Phong's widest lobe, a clamped cosine, in all directions of an octahedron: their sum is the mean light times 6/4.
        std::vector<TexelSum> sums;
        for (const double sign : {1.0, -1.0})
            for (int axis = 0; axis < 3; ++axis) {
                TexelSum sum;
                (axis == 0 ? sum.x : axis == 1 ? sum.y : sum.z) = sign;
                sum.lobe = phong_lobe(0.001);
                sums.push_back(sum);
            }
        sum_reading(with_sun(sun, 100.0f, 0.0f), sums);
        double total = 0.0;
        for (const TexelSum& sum : sums)
            total += sum.rgb[1];
        // With exponent 0 each of three hemispheres sees a direction whole.
        const double expected = 3.0 * 100.0 * testing::texel_area(sun.width, sun.height, sun.y) / (2.0 * pi);
        EXPECT_NEAR(total / expected, 1.0, 0.01) << sun.width << 'x' << sun.height << ", row " << sun.y;
    }
}

TEST(SmallBake, CoefficientsOfAConstant)
{
    for (const auto& [width, height] : {std::pair(2, 1), {4, 2}, {5, 3}, {64, 32}}) {
        const std::vector<double> c =
            irradiance_coefficients(project_to_harmonics(with_sun({width, height, 0, 0}, 1.0f)));
        EXPECT_NEAR(c[0], pi / 0.282095, 1e-3);
        for (std::size_t i = 3; i < c.size(); ++i)
            EXPECT_NEAR(c[i], 0.0, 2e-3) << width << 'x' << height << ", " << i;
    }
}

} // namespace
} // namespace lambent::environment
