// Sampled specular light against the integral over every texel in double.
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace lambent::draw {
namespace {

using glm::dvec3;

// Soft lamps of different sizes in a dim room.
glm::vec3 room(dvec3 d)
{
    const auto lamp = [&](dvec3 towards, double sharpness, double radiance) {
        return radiance * std::exp(sharpness * (glm::dot(d, glm::normalize(towards)) - 1.0));
    };
    const double light = 0.2 + 0.1 * d.y + lamp({1, 1, 1}, 60, 12) + lamp({-1, 0.4, 0.6}, 20, 3) +
                         lamp({0, -1, 0.3}, 6, 0.8) + lamp({0.2, 0.5, -1}, 200, 30);
    return glm::vec3(static_cast<float>(light));
}

// GGX with height-correlated Smith masking, F = 1, as a weight; from its definition.
double lobe(double cos_l, double cos_v, double cos_h, double alpha)
{
    const double a2 = alpha * alpha, q = cos_h * cos_h * (a2 - 1.0) + 1.0;
    const auto root = [a2](double c) { return std::sqrt(a2 + (1.0 - a2) * c * c); };
    return a2 / (q * q) * cos_l / (cos_l * root(cos_v) + cos_v * root(cos_l));
}

// The mean of the environment over the lobe: a white metal with what it loses given back.
double brute_force(dvec3 n, dvec3 v, double alpha, int width)
{
    const int height = width / 2;
    double sum = 0.0, weights = 0.0;
    for (int y = 0; y < height; ++y) {
        const double theta = (y + 0.5) / height * std::numbers::pi;
        for (int x = 0; x < width; ++x) {
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
            const dvec3 l(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            const double cos_l = glm::dot(n, l);
            if (cos_l <= 0.0)
                continue;
            const double w =
                lobe(cos_l, glm::dot(n, v), glm::dot(n, glm::normalize(l + v)), alpha) * std::sin(theta);
            sum += w * static_cast<double>(room(l).x);
            weights += w;
        }
    }
    return sum / weights;
}

// Relative root mean square error over a sphere's pixels.
double sphere_error(float roughness, int samples)
{
    constexpr int size = 256, width = 256;
    scene::Scene scene;
    scene::Material metal;
    metal.metallic = 1.0f;
    metal.perceptual_roughness = roughness;
    testing::add(scene, scene::make_sphere(0.5f, 256, 128), metal);
    Settings settings = testing::small_settings(size, size, testing::front_camera(1.0f));
    settings.samples = samples;
    settings.edge_samples = 1;
    const environment::Environment environment = testing::environment_of(width, room);
    const Frame frame = testing::draw(scene, &environment, settings);
    double error = 0.0, mean = 0.0, count = 0.0;
    for (int y = 8; y < size; y += 16)
        for (int x = 8; x < size; x += 16) {
            const double px = (x + 0.5) / size * 2.0 - 1.0, py = 1.0 - (y + 0.5) / size * 2.0;
            if (px * px + py * py > 0.97)
                continue;
            const dvec3 n(px, py, std::sqrt(1.0 - px * px - py * py));
            const double truth = brute_force(n, {0, 0, 1}, roughness * roughness, width);
            error += std::pow(static_cast<double>(testing::pixel(frame, x, y).x) - truth, 2);
            mean += truth;
            count += 1.0;
        }
    return std::sqrt(error / count) / (mean / count);
}

TEST(SpecularError, ShrinksWithTheNumberOfSamples)
{
    std::printf("roughness   40 samples   1024 samples   (relative RMSE over a sphere)\n");
    for (float roughness : {0.35f, 0.5f, 0.75f, 1.0f}) {
        const double few = sphere_error(roughness, 40), many = sphere_error(roughness, 1024);
        std::printf("%9.2f   %8.2f %%   %10.2f %%\n", static_cast<double>(roughness), few * 100, many * 100);
        EXPECT_LT(few, 0.065);
        EXPECT_LT(many, 0.012);
        EXPECT_LT(many, few);
    }
}

} // namespace
} // namespace lambent::draw
