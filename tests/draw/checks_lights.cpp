// Lamps by the words of KHR_lights_punctual; a sun in blurred backgrounds.
#include "environment/chain/cube_chain.h"
#include "environment/chain/lamps.h"
#include "tests/draw/backend_checks.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw::testing {
namespace {

using glm::dvec3;
using std::numbers::pi;

// What a lamp two metres above a matte white floor lights at `x` to its right, in the report's model: lux over pi.
double seen_at(const Draw& draw, const scene::Light& lamp, double x)
{
    scene::Scene scene;
    add(scene, facing_square(20.0f, 0.0f), matte(glm::vec3(1.0f)));
    Settings settings = small_settings(3, 3, front_camera(0.03f));
    settings.camera.position.x = static_cast<float>(x);
    settings.model = Model::phong;
    settings.lights = {lamp};
    return static_cast<double>(pixel(draw(scene, nullptr, settings), 1, 1).g);
}

} // namespace

// Candela cos / d^2, times a window of the range and the square of the way between the cones' cosines.
void expect_lamps(const Draw& draw)
{
    constexpr double height = 2.0, candela = 40.0, range = 4.0, inner = 0.3, outer = 0.8;
    scene::Light plain;
    plain.position = {0.0f, 0.0f, static_cast<float>(height)};
    plain.intensity = glm::vec3(static_cast<float>(candela));
    scene::Light ranged = plain, spot = plain;
    ranged.range = static_cast<float>(range);
    spot.kind = scene::LightKind::spot;
    spot.direction = {0.0f, 0.0f, -1.0f};
    spot.inner_cone = static_cast<float>(inner);
    spot.outer_cone = static_cast<float>(outer);
    for (const double x : {0.0, 0.5, 1.2, 1.7, 3.0, 4.5}) {
        const double d2 = x * x + height * height, cosine = height / std::sqrt(d2);
        const double free = candela * cosine / d2 / pi;
        const double window = std::clamp(1.0 - std::pow(d2 / (range * range), 2.0), 0.0, 1.0);
        const double part =
            std::clamp((cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 0.0, 1.0);
        EXPECT_NEAR(seen_at(draw, plain, x), free, 1e-4 * free) << x;
        EXPECT_NEAR(seen_at(draw, ranged, x), free * window, 1e-4 * free) << x;
        EXPECT_NEAR(seen_at(draw, spot, x), free * part * part, 1e-4 * free) << x;
    }
}

// Stripes of three degrees in pixels of eleven: a point is anything from 0 to 2, the mean of a pixel nearly 1. As a Gaussian of
// the pixel's variance takes exp(-k^2 s^2 / 2) of a wave, here exp(-6), and the level that is read for it at most that of
// its finer part. Pixels finer than the panorama's texels show those.
void expect_backgrounds_to_average(const Draw& draw)
{
    const environment::Environment light = environment_of(512, [](dvec3 d) {
        return glm::vec3(static_cast<float>(1.0 + std::sin(60.0 * std::atan2(d.z, d.x))));
    });
    scene::Scene nothing;
    nothing.materials.emplace_back();
    Settings settings = small_settings(16, 3, Camera{});
    settings.camera.vertical_fov = 0.6f;
    settings.background.kind = Background::Kind::environment;
    const Frame coarse = draw(nothing, &light, settings);
    for (int x = 4; x < 12; ++x)
        EXPECT_NEAR(pixel(coarse, x, 1).g, 1.0f, 0.15f) << x;
    settings.camera.vertical_fov = 0.02f;
    const Frame fine = draw(nothing, &light, settings);
    float low = 2.0f, high = 0.0f;
    for (int x = 0; x < 16; ++x) {
        low = std::min(low, pixel(fine, x, 1).g);
        high = std::max(high, pixel(fine, x, 1).g);
    }
    EXPECT_LT(low, 0.2f);
    EXPECT_GT(high, 1.8f);
    // A quarter of a row from the pole, which is half a row from the middles of the first row: it goes on across the pole.
    const environment::Environment halves =
        environment_of(512, [](dvec3 d) { return glm::vec3(d.x > 0.0 ? 2.0f : 0.0f); });
    settings.width = 3;
    settings.camera.vertical_fov = static_cast<float>(2.0 * std::atan(1.5 * std::tan(0.25 * pi / 256)));
    for (const float side : {1.0f, -1.0f}) { // straight up and straight down
        settings.camera.back = {0.0f, -side, 0.0f};
        settings.camera.right = {1.0f, 0.0f, 0.0f};
        settings.camera.up = glm::cross(settings.camera.back, settings.camera.right);
        const Frame pole = draw(nothing, &halves, settings);
        EXPECT_NEAR(pixel(pole, 2, 1).g, 0.75f * 2.0f, 0.01f);
        EXPECT_NEAR(pixel(pole, 0, 1).g, 0.25f * 2.0f, 0.01f);
    }
}

// A small sun in the dark, blurred: what a camera that looks at it sees, summed over solid angle, is its light, as long as
// the blur fits into the picture. Blurs by one level alone, by two, and by levels with and without the sun in them.
void expect_blurs_to_keep_light(const Draw& draw)
{
    const dvec3 towards = glm::normalize(dvec3(0.35, 0.2, -1.0));
    const auto is_sun = [&](dvec3 d) { return glm::dot(d, towards) > std::cos(0.012); };
    const environment::Environment light =
        environment_of(512, [&](dvec3 d) { return glm::vec3(is_sun(d) ? 1000.0f : 0.0f); });
    double wanted = 0.0; // of the texels that it was painted into
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x) {
            const double phi = ((x + 0.5) / 512 - 0.5) * 2.0 * pi, theta = (y + 0.5) / 512 * 2.0 * pi;
            const dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            wanted += is_sun(d) ? 1000.0 * std::sin(theta) * std::pow(2.0 * pi / 512, 2.0) : 0.0;
        }
    ASSERT_GT(wanted, 0.0);
    scene::Scene nothing;
    nothing.materials.emplace_back();
    constexpr int size = 320;
    Settings settings = small_settings(size, size, Camera{});
    settings.camera.vertical_fov = 1.6f;
    settings.camera.back = glm::vec3(-towards);
    settings.camera.right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), settings.camera.back));
    settings.camera.up = glm::cross(settings.camera.back, settings.camera.right);
    settings.background.kind = Background::Kind::blurred;
    const double v1 = std::pow(static_cast<double>(environment::level_one_deviation(light.chain)), 2.0);
    for (const double variance : {0.3, 0.8, 1.0, 2.5, 4.0, 9.0}) {
        settings.background.roughness = static_cast<float>(std::pow(variance * v1, 0.25));
        const Frame frame = draw(nothing, &light, settings);
        double seen = 0.0;
        const double step = 2.0 * std::tan(0.8) / size;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double a = (x + 0.5 - 0.5 * size) * step, b = (y + 0.5 - 0.5 * size) * step;
                seen += static_cast<double>(pixel(frame, x, y).g) * step * step /
                        std::pow(1.0 + a * a + b * b, 1.5);
            }
        EXPECT_NEAR(seen / wanted, 1.0, 0.02)
            << variance << " of level 1's variance, lamps to level " << light.lamps.last_level;
    }
}

// A dozen dots of light around a point, near enough to be one lamp whose light has a spread of its own. Through a blur of
// deviation s the point shows what each dot, at the angle r, gives it: light exp(-r^2 / (2 s^2)) / (2 pi s^2).
void expect_merged_lamps_to_spread(const Draw& draw)
{
    const dvec3 towards = glm::normalize(dvec3(0.35, 0.2, -1.0));
    const dvec3 right = glm::normalize(glm::cross(dvec3(0, 1, 0), -towards)),
                up = glm::cross(-towards, right);
    constexpr int dots = 12, width = 512;
    const auto dot_of = [&](dvec3 d) {
        double nearest = -1.0;
        for (int i = 0; i < dots; ++i) {
            const double a = 2.0 * pi * i / dots;
            const dvec3 dot = glm::normalize(towards + 0.034 * (std::cos(a) * right + std::sin(a) * up));
            nearest = std::max(nearest, glm::dot(d, dot));
        }
        return nearest > std::cos(0.0065);
    };
    const environment::Environment light =
        environment_of(width, [&](dvec3 d) { return glm::vec3(dot_of(d) ? 1000.0f : 0.0f); });
    const double v1 = std::pow(static_cast<double>(environment::level_one_deviation(light.chain)), 2.0);
    scene::Scene nothing;
    nothing.materials.emplace_back();
    Settings settings = small_settings(9, 9, Camera{});
    settings.camera.vertical_fov = 0.02f;
    settings.camera.back = glm::vec3(-towards);
    settings.camera.right = glm::vec3(right);
    settings.camera.up = glm::vec3(up);
    settings.background.kind = Background::Kind::blurred;
    // By one level alone: between two the blur is a mixture of theirs, which is no Gaussian.
    for (const double level : {2.0, 3.0}) {
        const double s2 = v1 * std::pow(4.0, level - 1.0);
        double wanted = 0.0; // of the texels that were painted
        for (int y = 0; y < width / 2; ++y)
            for (int x = 0; x < width; ++x) {
                const double phi = ((x + 0.5) / width - 0.5) * 2.0 * pi, theta = (y + 0.5) / width * 2.0 * pi;
                const dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                              std::sin(theta) * std::sin(phi));
                const double r = std::acos(std::min(glm::dot(d, towards), 1.0));
                if (dot_of(d))
                    wanted += 1000.0 * std::sin(theta) * std::pow(2.0 * pi / width, 2.0) *
                              std::exp(-0.5 * r * r / s2) / (2.0 * pi * s2);
            }
        settings.background.roughness = static_cast<float>(std::pow(s2, 0.25));
        const double seen = static_cast<double>(pixel(draw(nothing, &light, settings), 4, 4).g);
        EXPECT_NEAR(seen / wanted, 1.0, 0.025)
            << "level " << level << ", lamps to level " << light.lamps.last_level;
    }
}

} // namespace lambent::draw::testing
