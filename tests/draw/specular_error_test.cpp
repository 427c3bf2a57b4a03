// Sampled specular light against the integral over every texel in double.
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace lambent::draw {
namespace {

using glm::dvec3;
using std::numbers::pi;

// Soft lamps of different sizes in a dim room.
double room(dvec3 d)
{
    const auto lamp = [&](dvec3 towards, double sharpness, double radiance) {
        return radiance * std::exp(sharpness * (glm::dot(d, glm::normalize(towards)) - 1.0));
    };
    return 0.2 + 0.1 * d.y + lamp({1, 1, 1}, 60, 12) + lamp({-1, 0.4, 0.6}, 20, 3) +
           lamp({0, -1, 0.3}, 6, 0.8) + lamp({0.2, 0.5, -1}, 200, 30);
}

// A sky that is brighter above.
double sky(dvec3 d)
{
    return 1.0 + 0.5 * d.y;
}

// A sun of 0.53 degrees, as hard as a panorama can hold it: texels lit or not.
bool in_sun(dvec3 d)
{
    return glm::dot(d, glm::normalize(dvec3(0.5, 0.6, 0.7))) > std::cos(0.265 * pi / 180.0);
}

// A texel as light: where it is, its radiance, its solid angle.
struct Texel {
    dvec3 direction;
    double radiance, area;
};

template <class Radiance>
std::vector<Texel> texels_of(int width, const Radiance& radiance)
{
    std::vector<Texel> texels;
    for (int y = 0; y < width / 2; ++y)
        for (int x = 0; x < width; ++x) {
            const double theta = (y + 0.5) / width * 2.0 * pi, phi = ((x + 0.5) / width - 0.5) * 2.0 * pi;
            const dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            texels.push_back({d, radiance(d), std::sin(theta) * std::pow(2.0 * pi / width, 2)});
        }
    return texels;
}

// An environment, and the same for the integral: soft light from coarse texels, a sun from its own.
struct Place {
    environment::Environment drawn;
    std::vector<Texel> soft, sun;
};

Place soft_room()
{
    return {testing::environment_of(256, [](dvec3 d) { return glm::vec3(static_cast<float>(room(d))); }),
            texels_of(256, room),
            {}};
}

constexpr double sun_radiance = 50000.0;

Place hard_sun()
{
    constexpr int width = 2048;
    Place place;
    place.drawn = testing::environment_of(
        width, [](dvec3 d) { return glm::vec3(static_cast<float>(in_sun(d) ? sun_radiance : sky(d))); });
    place.soft = texels_of(256, sky);
    for (const Texel& texel : texels_of(width, [](dvec3 d) { return in_sun(d) ? sun_radiance : 0.0; }))
        if (texel.radiance > 0.0)
            place.sun.push_back(texel);
    return place;
}

// What reflects: a white metal with all that it loses given back, so that it shows the mean over the lobe; or a black
// dielectric, whose light scattered once by Schlick's reflectance is compared as it is.
enum class Surface { white_metal, black_dielectric };

// GGX with height-correlated Smith masking: D G2 / (4 NV), from its definition.
double lobe(double cos_l, double cos_v, double cos_h, double alpha)
{
    const double a2 = alpha * alpha, q = cos_h * cos_h * (a2 - 1.0) + 1.0;
    const auto root = [a2](double c) { return std::sqrt(a2 + (1.0 - a2) * c * c); };
    return a2 / (q * q) * cos_l / (cos_l * root(cos_v) + cos_v * root(cos_l)) / (2.0 * pi);
}

double brute_force(const Place& place, Surface surface, dvec3 n, double alpha)
{
    const dvec3 v(0, 0, 1);
    double sum = 0.0, weights = 0.0;
    const auto add = [&](const Texel& texel, double counted) {
        const double cos_l = glm::dot(n, texel.direction);
        if (cos_l <= 0.0)
            return;
        const dvec3 h = glm::normalize(texel.direction + v);
        const double F =
            surface == Surface::white_metal ? 1.0 : 0.04 + 0.96 * std::pow(1.0 - glm::dot(v, h), 5.0);
        const double w = F * lobe(cos_l, glm::dot(n, v), glm::dot(n, h), alpha) * texel.area;
        sum += w * texel.radiance;
        weights += counted * w;
    };
    for (const Texel& texel : place.soft)
        add(texel, 1.0);
    for (const Texel& texel : place.sun)
        add(texel, 0.0);
    return surface == Surface::white_metal ? sum / weights : sum;
}

constexpr int size = 256, step = 16;

// Calls visit(x, y, normal) for some pixels of a sphere that fills the picture.
template <class Visit>
void for_some_pixels(Visit&& visit)
{
    for (int y = step / 2; y < size; y += step)
        for (int x = step / 2; x < size; x += step) {
            const double px = (x + 0.5) / size * 2.0 - 1.0, py = 1.0 - (y + 0.5) / size * 2.0;
            if (px * px + py * py <= 0.97)
                visit(x, y, dvec3(px, py, std::sqrt(1.0 - px * px - py * py)));
        }
}

Frame draw_sphere(const Place& place, Surface surface, float roughness, int samples)
{
    scene::Scene scene;
    scene::Material material;
    material.perceptual_roughness = roughness;
    if (surface == Surface::black_dielectric) {
        material.metallic = 0.0f;
        material.base_color = {0.0f, 0.0f, 0.0f, 1.0f};
    }
    testing::add(scene, scene::make_sphere(0.5f, 256, 128), material);
    Settings settings = testing::small_settings(size, size, testing::front_camera(1.0f));
    settings.samples = samples;
    settings.edge_samples = 1;
    settings.energy_compensation = surface == Surface::white_metal;
    return testing::draw(scene, &place.drawn, settings);
}

// Relative root mean square error over the sphere.
double error_of(const Frame& frame, const std::vector<double>& truths)
{
    double error = 0.0, mean = 0.0;
    std::size_t next = 0;
    for_some_pixels([&](int x, int y, dvec3) {
        const double truth = truths[next++];
        error += std::pow(static_cast<double>(testing::pixel(frame, x, y).x) - truth, 2);
        mean += truth;
    });
    const double count = static_cast<double>(truths.size());
    return std::sqrt(error / count) / (mean / count);
}

struct Bound {
    float roughness;
    double few, many; // samples
};

void expect_errors_below(const std::vector<Bound>& bounds, const Place& place, Surface surface)
{
    std::printf("roughness   40 samples   1024 samples   (relative RMSE over a sphere)\n");
    for (const Bound& bound : bounds) {
        std::vector<double> truths;
        for_some_pixels([&](int, int, dvec3 n) {
            truths.push_back(
                brute_force(place, surface, n, std::pow(static_cast<double>(bound.roughness), 2)));
        });
        const double few = error_of(draw_sphere(place, surface, bound.roughness, 40), truths);
        const double many = error_of(draw_sphere(place, surface, bound.roughness, 1024), truths);
        std::printf("%9.2f   %8.2f %%   %10.2f %%\n", static_cast<double>(bound.roughness), few * 100,
                    many * 100);
        EXPECT_LT(few, bound.few) << bound.roughness;
        EXPECT_LT(many, bound.many) << bound.roughness;
        EXPECT_LT(many, std::max(few, 0.0005)) << bound.roughness; // below, half floats are to be seen
    }
}

TEST(SpecularError, ShrinksWithTheNumberOfSamples)
{
    expect_errors_below(
        {{0.35f, 0.036, 0.0070}, {0.5f, 0.019, 0.0022}, {0.75f, 0.018, 0.0009}, {1.0f, 0.0185, 0.0007}},
        soft_room(), Surface::white_metal);
}

// A sun is narrower than any sample's share of a lobe: it is a lamp, which the lobe itself is evaluated for.
TEST(SpecularError, OfAHardSunShrinksToo)
{
    expect_errors_below(
        {{0.35f, 0.0026, 0.0015}, {0.5f, 0.0025, 0.0009}, {0.75f, 0.0012, 0.0006}, {1.0f, 0.0008, 0.0006}},
        hard_sun(), Surface::white_metal);
}

// Most of what a dielectric reflects comes from its rim, where a lamp behind it is mirrored at grazing angles.
TEST(SpecularError, OfADielectricShrinksToo)
{
    expect_errors_below(
        {{0.35f, 0.150, 0.0375}, {0.5f, 0.120, 0.015}, {0.75f, 0.068, 0.006}, {1.0f, 0.068, 0.0063}},
        soft_room(), Surface::black_dielectric);
}

} // namespace
} // namespace lambent::draw
