// Blurred backgrounds across the edges and corners of the cube that they are kept on.
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

// Blurred light towards directions along a great circle, from `from` towards `to` and on, one every `step` radians.
std::vector<double> along(const environment::Environment& environment, float roughness, const dvec3& from,
                          const dvec3& to, double step, int count)
{
    scene::Scene nothing;
    nothing.materials.emplace_back();
    const dvec3 aside = glm::normalize(to - glm::dot(from, to) * from);
    std::vector<double> values;
    // Narrow pictures, one row each: pixels of `step`.
    constexpr int width = 16;
    for (int first = 0; first < count; first += width) {
        const double middle = (first + 0.5 * width) * step;
        const dvec3 ahead = std::cos(middle) * from + std::sin(middle) * aside;
        const dvec3 right = -std::sin(middle) * from + std::cos(middle) * aside;
        Camera camera;
        camera.vertical_fov = static_cast<float>(2.0 * std::atan(std::tan(0.5 * step)));
        camera.back = glm::vec3(-ahead);
        camera.right = glm::vec3(right);
        camera.up = glm::vec3(glm::cross(-ahead, right));
        Settings settings = testing::small_settings(width, 1, camera);
        settings.background.kind = Background::Kind::blurred;
        settings.background.roughness = roughness;
        const Frame frame = testing::draw(nothing, &environment, settings);
        for (int x = 0; x < width; ++x)
            values.push_back(static_cast<double>(testing::pixel(frame, x, 0).g));
    }
    return values;
}

// A half of the sphere shines, as hard as a panorama can hold it, and obliquely to every face.
environment::Environment half_lit()
{
    const dvec3 towards = glm::normalize(dvec3(0.3, 0.5, -0.8));
    return testing::environment_of(
        512, [=](dvec3 d) { return glm::vec3(glm::dot(d, towards) > 0.0 ? 2.0f : 0.1f); });
}

double largest_step(const std::vector<double>& values, int first, int end)
{
    double largest = 0.0;
    for (int i = first; i < end; ++i)
        largest = std::max(largest, std::fabs(values[static_cast<std::size_t>(i)] -
                                              values[static_cast<std::size_t>(i) - 1]));
    return largest;
}

// Across an edge or a corner, in the middle of `values`, neighbours differ as they do beside it.
TEST(BlurEdges, NoStepAtEdgesAndCornersOfTheCube)
{
    const environment::Environment environment = half_lit();
    constexpr double step = 0.0005;
    constexpr int count = 256;
    double worst = 0.0;
    const dvec3 edges[] = {{1, 0, 1},     {1, 0, -1},   {-1, 0, 1},   {-1, 0, -1},  {1, 1, 0.3},
                           {1, -1, -0.6}, {-0.2, 1, 1}, {0.7, 1, -1}, {-1, 1, 0.9}, {0.95, -1, 1},
                           {1, 1, 1},     {-1, 1, 1},   {1, -1, 1},   {1, 1, -1},   {-1, -1, -1},
                           {1, 0.4, 1},   {1, -0.9, 1}};
    for (const float roughness : {0.2f, 0.4f, 0.6f, 0.8f, 1.0f})
        for (const dvec3& edge : edges) {
            // Across it, by a direction that is neither along it nor square to it.
            const dvec3 middle = glm::normalize(edge);
            const dvec3 across =
                glm::normalize(glm::cross(middle, glm::cross(dvec3(0.9, -0.4, -0.3), middle)));
            const double half = 0.5 * count * step;
            const dvec3 from = std::cos(half) * middle - std::sin(half) * across;
            const std::vector<double> values = along(environment, roughness, from, middle, step, count);
            const double there = largest_step(values, count / 2 - 3, count / 2 + 4);
            const double beside = std::max(largest_step(values, 8, count / 2 - 8),
                                           largest_step(values, count / 2 + 8, count - 8));
            worst = std::max(worst, (there - 1.5 * beside) / values[count / 2]);
            EXPECT_LT(there, 1.5 * beside + 2e-4 * values[count / 2])
                << roughness << ", " << edge.x << ' ' << edge.y << ' ' << edge.z;
        }
    std::printf("largest step beyond that beside it: %.4f %% of the light\n", 100.0 * std::max(worst, 0.0));
}

double bend(const std::vector<double>& values, int i)
{
    const auto at = static_cast<std::size_t>(i);
    return std::fabs(values[at + 1] - 2.0 * values[at] + values[at - 1]);
}

// Nor a crease: slopes change across an edge no more than they do between the texels of a face.
TEST(BlurEdges, NoCreaseAtEdgesAndCornersOfTheCube)
{
    const environment::Environment environment = half_lit();
    constexpr double step = 0.004;
    constexpr int count = 480;
    for (const float roughness : {0.3f, 0.4f, 0.5f, 0.6f, 0.8f, 1.0f}) {
        double there = 0.0, beside = 0.0;
        for (const dvec3& edge :
             {dvec3(1, 0.5, 1), dvec3(1, -0.4, -1), dvec3(-1, 0.6, 1), dvec3(-1, -0.5, -1), dvec3(1, 1, 0.4),
              dvec3(1, 1, 1), dvec3(-0.4, 1, 1), dvec3(-1, 1, -1), dvec3(0.5, -1, 1)}) {
            const dvec3 middle = glm::normalize(edge);
            const dvec3 across =
                glm::normalize(glm::cross(middle, glm::cross(dvec3(0.9, -0.4, -0.3), middle)));
            const double half = 0.5 * count * step;
            const dvec3 from = std::cos(half) * middle - std::sin(half) * across;
            const std::vector<double> values = along(environment, roughness, from, middle, step, count);
            for (int i = 1; i + 1 < count; ++i)
                (std::abs(i - count / 2) < 4 ? there : beside) =
                    std::max(std::abs(i - count / 2) < 4 ? there : beside, bend(values, i));
        }
        std::printf("roughness %.1f: largest bend at edges %.2e, elsewhere %.2e\n",
                    static_cast<double>(roughness), there, beside);
        EXPECT_LT(there, 1.2 * beside) << roughness;
    }
}

// A panorama that changes along one axis is that also blurred: its gradient points where it did.
TEST(BlurEdges, NoBlurTurnsALinearPanorama)
{
    double worst = 0.0;
    for (const dvec3& given :
         {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(0.3, 0.8, -0.4), dvec3(-1, 0.6, 0.9)}) {
        const dvec3 towards = glm::normalize(given);
        const environment::Environment environment = testing::environment_of(
            512, [=](dvec3 d) { return glm::vec3(static_cast<float>(1.0 + 0.5 * glm::dot(d, towards))); });
        for (const float roughness : {0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
            // The first moment of the light, from pictures of the six sides.
            dvec3 moment(0.0);
            constexpr int size = 32;
            scene::Scene nothing;
            nothing.materials.emplace_back();
            for (int side = 0; side < 6; ++side) {
                dvec3 axes[3] = {dvec3(0.0), dvec3(0.0), dvec3(0.0)};
                axes[2][side / 2] = side % 2 ? 1.0 : -1.0;
                axes[0][(side / 2 + 1) % 3] = 1.0;
                axes[1] = glm::cross(axes[2], axes[0]);
                Camera camera;
                camera.vertical_fov = static_cast<float>(0.5 * pi);
                camera.right = glm::vec3(axes[0]);
                camera.up = glm::vec3(axes[1]);
                camera.back = glm::vec3(axes[2]);
                Settings settings = testing::small_settings(size, size, camera);
                settings.background.kind = Background::Kind::blurred;
                settings.background.roughness = roughness;
                const Frame frame = testing::draw(nothing, &environment, settings);
                for (int y = 0; y < size; ++y)
                    for (int x = 0; x < size; ++x) {
                        const double u = 2.0 * (x + 0.5) / size - 1.0, v = 1.0 - 2.0 * (y + 0.5) / size;
                        const dvec3 d = u * axes[0] + v * axes[1] - axes[2];
                        moment += d * (static_cast<double>(testing::pixel(frame, x, y).g) *
                                       std::pow(glm::dot(d, d), -2.0));
                    }
            }
            const double turned =
                std::asin(std::min(glm::length(glm::cross(glm::normalize(moment), towards)), 1.0)) * 180.0 /
                pi;
            worst = std::max(worst, turned);
            // The widest is of 24 half floats, whose rounding alone turns it by some hundredths.
            EXPECT_LT(turned, roughness < 0.9f ? 0.02 : 0.05)
                << "roughness " << roughness << ", " << given.x << ' ' << given.y << ' ' << given.z;
        }
    }
    std::printf("turned by up to %.4f degrees\n", worst);
}

} // namespace
} // namespace lambent::draw
