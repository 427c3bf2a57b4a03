// What the report's model reflects of a white environment: its BRDF by quadrature, and its specular pass as drawn.
// docs/PHONG.md shows the table; here it is measured again.
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace lambent::draw {
namespace {

constexpr double exponents[] = {0.1, 1.0, 20.0, 625.0, 15625.0, 390625.0};
constexpr double degrees[] = {0.0, 30.0, 60.0, 80.0};

// Directional albedo of D F / (4 (L.H)^2) for F = 1. With dL = 4 (V.H) dH and the polar angle of H drawn so that it
// has density D: the mean of (alpha + 2) / (alpha + 1) * N.L / V.H.
double albedo_of_brdf(double exponent, double angle)
{
    constexpr int steps = 512;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double cosine = std::pow((i + 0.5) / steps, 1.0 / (exponent + 1.0));
        const double sine = std::sqrt(1.0 - cosine * cosine);
        for (int j = 0; j < steps; ++j) {
            const double phi = 2.0 * std::numbers::pi * (j + 0.5) / steps;
            const double VH = sine * std::cos(phi) * std::sin(angle) + cosine * std::cos(angle);
            const double NL = 2.0 * VH * cosine - std::cos(angle);
            if (VH > 0.0 && NL > 0.0)
                sum += NL / VH;
        }
    }
    return sum / (steps * steps) * (exponent + 2.0) / (exponent + 1.0);
}

// What the report's pass tends to with many samples: over the lobe about the mirrored view, of density (alpha + 1) /
// (2 pi) cos^alpha, the mean of max(N.w, 0) / (4 (w.H)^2).
double albedo_of_pass(double exponent, double angle)
{
    constexpr int steps = 512;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double cosine = std::pow((i + 0.5) / steps, 1.0 / (exponent + 1.0));
        const double sine = std::sqrt(1.0 - cosine * cosine);
        for (int j = 0; j < steps; ++j) {
            const double phi = 2.0 * std::numbers::pi * (j + 0.5) / steps;
            // In a frame of R, with N and V at `angle` and twice that from it; w.H is the cosine of half of w to V.
            const double across = sine * std::cos(phi);
            const double NL = across * std::sin(angle) + cosine * std::cos(angle);
            const double wV = across * std::sin(2.0 * angle) + cosine * std::cos(2.0 * angle);
            if (NL > 0.0)
                sum += NL / (2.0 * (1.0 + wV));
        }
    }
    return sum / (steps * steps);
}

double albedo_as_drawn(double exponent, double angle, int samples = 40)
{
    scene::Material material;
    material.phong = scene::PhongMaterial{glm::vec3(0.0f), glm::vec3(1.0f), static_cast<float>(exponent)};
    scene::Scene scene;
    testing::add(scene, testing::facing_square(1.0f, 0.0f), material,
                 glm::rotate(glm::mat4(1.0f), static_cast<float>(angle), glm::vec3(0.0f, 1.0f, 0.0f)));
    Settings settings = testing::small_settings(3, 3, testing::front_camera(0.01f));
    settings.model = Model::phong;
    settings.samples = samples;
    const environment::Environment white = testing::white_environment();
    return static_cast<double>(testing::pixel(testing::draw(scene, &white, settings), 1, 1).r);
}

// The numbers of the table's rows, in the order of reading.
std::vector<double> documented()
{
    std::ifstream file(LAMBENT_DOCS "/PHONG.md");
    std::vector<double> numbers;
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("| ", 0) != 0 || line.find(" / ") == std::string::npos)
            continue;
        for (char& c : line)
            c = c == '|' || c == '/' ? ' ' : c;
        std::istringstream words(line);
        for (double number; words >> number;)
            numbers.push_back(number);
    }
    return numbers;
}

TEST(PhongAlbedo, IsWhatTheDocumentationSays)
{
    const std::vector<double> table = documented();
    ASSERT_EQ(table.size(), std::size(exponents) * (1 + 2 * std::size(degrees)));
    std::size_t next = 0;
    for (const double exponent : exponents) {
        std::printf("| %g |", exponent);
        EXPECT_EQ(table[next++], exponent);
        for (const double degree : degrees) {
            const double angle = degree * std::numbers::pi / 180.0;
            const double brdf = albedo_of_brdf(exponent, angle), drawn = albedo_as_drawn(exponent, angle);
            std::printf(" %.3f / %.3f |", brdf, drawn);
            EXPECT_NEAR(table[next++], brdf, 0.001) << exponent << " at " << degree;
            EXPECT_NEAR(table[next++], drawn, 0.002) << exponent << " at " << degree;
        }
        std::printf("\n");
    }
}

// Forty points do not quite follow where the horizon cuts the lobe.
TEST(PhongAlbedo, IsTheMeanOverTheLobe)
{
    for (const double exponent : exponents)
        for (const double degree : degrees) {
            const double angle = degree * std::numbers::pi / 180.0, mean = albedo_of_pass(exponent, angle);
            EXPECT_NEAR(albedo_as_drawn(exponent, angle) / mean, 1.0, 0.0125) << exponent << " at " << degree;
            EXPECT_NEAR(albedo_as_drawn(exponent, angle, 1024) / mean, 1.0, 0.001)
                << exponent << " at " << degree;
        }
}

// For narrow lobes both are the mirror's 1 / cos, up to what the horizon cuts.
TEST(PhongAlbedo, NarrowLobesReflectAsTheirMaskingSays)
{
    for (const double degree : {0.0, 30.0, 60.0}) {
        const double angle = degree * std::numbers::pi / 180.0;
        EXPECT_NEAR(albedo_as_drawn(390625.0, angle), 0.25 / std::cos(angle), 0.01);
    }
}

} // namespace
} // namespace lambent::draw
