// The split-sum table against quadrature of the BRDF over directions, which shares no sampling with it.
#include "albedo/albedo_table.h"
#include "environment/bake/bake.h"
#include "environment/bake/split_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace lambent::environment {
namespace {

struct Pair {
    double x, y;
};

// GGX with height-correlated Smith masking, from its definition. [Walter et al. 2007 eq. 33; Heitz 2014 eq. 72, 99]
double brdf_cosine(double cos_l, double cos_v, double cos_h, double alpha)
{
    const double a2 = alpha * alpha, tan2 = (1.0 - cos_h * cos_h) / (cos_h * cos_h);
    const double d = a2 / (std::numbers::pi * std::pow(cos_h, 4) * std::pow(a2 + tan2, 2));
    const auto lambda = [a2](double c) {
        return (std::sqrt(1.0 + a2 * (1.0 - c * c) / (c * c)) - 1.0) / 2.0;
    };
    return d / (1.0 + lambda(cos_l) + lambda(cos_v)) / (4.0 * cos_v);
}

// Over facet normals h by polar angle and azimuth: dl = 4 (v.h) dh. tan(theta) = alpha s / (1 - s) resolves the peak.
Pair quadrature(double cos_v, double alpha)
{
    const double sin_v = std::sqrt(1.0 - cos_v * cos_v);
    constexpr int steps = 800, azimuths = 64;
    double all = 0.0, grazing = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double s = (i + 0.5) / steps, tangent = alpha * s / (1.0 - s);
        const double cos_h = 1.0 / std::sqrt(1.0 + tangent * tangent), sin_h = tangent * cos_h;
        const double jacobian = alpha / ((1.0 - s) * (1.0 - s)) * cos_h * cos_h * sin_h / steps;
        for (int j = 0; j < azimuths; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / azimuths; // half of the circle, twice
            const double v_h = sin_v * sin_h * std::cos(phi) + cos_v * cos_h;
            const double cos_l = 2.0 * v_h * cos_h - cos_v;
            if (v_h <= 0.0 || cos_l <= 0.0)
                continue;
            const double weight = 2.0 * jacobian * std::numbers::pi / azimuths;
            const double value = brdf_cosine(cos_l, cos_v, cos_h, alpha) * 4.0 * v_h * weight;
            all += value;
            grazing += value * std::pow(1.0 - v_h, 5);
        }
    }
    return {all - grazing, grazing};
}

TEST(AlbedoTable, TheOneForOthersAgreesToo)
{
    constexpr int size = 128;
    const image::RadianceImage table = bake_split_sum_table(size);
    double square[2] = {}, mean[2] = {};
    int count = 0;
    for (int y = 3; y < size; y += 10)
        for (int x = 0; x < size; x += 10, ++count) {
            const double roughness = (y + 0.5) / size;
            const Pair expected = quadrature((x + 0.5) / size, roughness * roughness);
            const float* found = table.pixel(x, y);
            square[0] += std::pow(static_cast<double>(found[0]) - expected.x, 2);
            square[1] += std::pow(static_cast<double>(found[1]) - expected.y, 2);
            mean[0] += expected.x;
            mean[1] += expected.y;
            // Of a white metal, for the energy that is scattered more than once.
            EXPECT_FLOAT_EQ(found[2], found[0] + found[1]);
        }
    for (int k = 0; k < 2; ++k)
        EXPECT_LT(std::sqrt(square[k] / count), 0.0005 * mean[k] / count) << k;
}

TEST(AlbedoTable, AgreesWithQuadratureOverDirections)
{
    constexpr int n = albedo_table_size;
    double worst = 0.0;
    for (int row : {4, 10, 21, 32, 45, 63})
        for (int column : {8, 16, 27, 40, 52, 63}) {
            const double root = column / (n - 1.0), roughness = row / (n - 1.0);
            const Pair expected = quadrature(root * root, roughness * roughness);
            const float* entry = albedo_table + 2 * (row * n + column);
            worst = std::max({worst, std::fabs(entry[0] - expected.x), std::fabs(entry[1] - expected.y)});
            EXPECT_NEAR(entry[0], expected.x, 3e-4) << "row " << row << " column " << column;
            EXPECT_NEAR(entry[1], expected.y, 3e-4) << "row " << row << " column " << column;
        }
    std::printf("worst difference to quadrature: %.1e\n", worst);
}

TEST(AlbedoTable, AMirrorReflectsEverything)
{
    for (int column = 8; column < albedo_table_size; ++column)
        EXPECT_NEAR(albedo_table[2 * column] + albedo_table[2 * column + 1], 1.0f, 1e-3f);
}

} // namespace
} // namespace lambent::environment
