// What the tracer says of its own noise: true over many pictures, and the same whoever counts.
#include "tests/reference/traced.h"

#include <tbb/global_control.h>

namespace lambent::reference {
namespace {

using namespace testing;

scene::Scene ball_on_wall()
{
    scene::Scene scene = scene_of(facing_square(3.0f, -0.5f), metallic(0.6f, 0.0f, 0.9f));
    add(scene, scene::make_sphere(0.5f, 32, 16), metallic(0.8f, 1.0f, 0.4f));
    return scene;
}

image::RadianceImage sky()
{
    return panorama_of(64, [](const glm::dvec3& d) { return glm::dvec3(1.0 + d.x, 1.0, 1.5 + d.y); });
}

// Each value is a mean of 8 independent replicates, so its error over its estimated deviation is Student's t of 7
// degrees of freedom, whose square is 7/5 on average, with a standard deviation of 2.8. Over 200 x 64 pixels that is
// known to 0.025 (one standard deviation), were replicates quite normal; six of these are allowed.
TEST(ReferenceVariance, IsWhatPicturesWithOtherNoiseShow)
{
    constexpr int pictures = 200, pixels = 64;
    const scene::Scene scene = ball_on_wall();
    const image::RadianceImage light = sky();
    Settings settings = small_settings(8, 2.0f, 64);
    settings.bounces = 2;
    std::vector<Result> results;
    for (int i = 0; i < pictures; ++i) {
        settings.seed = static_cast<std::uint32_t>(i);
        results.push_back(trace(scene, &light, settings));
    }
    double squares = 0.0;
    for (std::size_t i = 0; i < pixels; ++i) {
        double truth = 0.0;
        for (const Result& result : results)
            truth += static_cast<double>(result.radiance.values[4 * i + 1]) / pictures;
        for (const Result& result : results) {
            const double error = static_cast<double>(result.radiance.values[4 * i + 1]) - truth;
            squares += error * error / static_cast<double>(result.variance.values[3 * i + 1]);
        }
    }
    // The truth is the mean of the pictures themselves, which takes 1 of 200.
    EXPECT_NEAR(squares / (pixels * (pictures - 1.0)), 7.0 / 5.0, 0.15);
}

// Pictures whose relative error is e differ by e times the root of two.
TEST(ReferenceVariance, NoiseIsTheRelativeError)
{
    const scene::Scene scene = ball_on_wall();
    const image::RadianceImage light = sky();
    Settings settings = small_settings(32, 2.0f, 64);
    const Result a = trace(scene, &light, settings);
    settings.seed = 99;
    const Result b = trace(scene, &light, settings);
    double squares = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < 32 * 32; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = static_cast<double>(a.radiance.values[4 * i + c]);
            const double y = static_cast<double>(b.radiance.values[4 * i + c]);
            squares += (x - y) * (x - y);
            sum += x;
        }
    const double count = 3.0 * 32.0 * 32.0;
    EXPECT_NEAR(std::sqrt(0.5 * squares / count) / (sum / count) / a.noise.value().all, 1.0, 0.1);
}

TEST(ReferenceVariance, FallsWithTheSamples)
{
    const scene::Scene scene = ball_on_wall();
    const image::RadianceImage light = sky();
    const Result few = trace(scene, &light, small_settings(16, 2.0f, 16));
    const Result many = trace(scene, &light, small_settings(16, 2.0f, 256));
    // Sixteen times the samples: a quarter of the noise, or less where points are spread evenly.
    EXPECT_LT(many.noise.value().all, 0.27 * few.noise.value().all);
}

TEST(ReferenceVariance, TheSamePictureOnAnyNumberOfThreads)
{
    const scene::Scene scene = ball_on_wall();
    const image::RadianceImage light = sky();
    Settings settings = small_settings(40, 2.0f, 24);
    std::vector<Result> results;
    for (const std::size_t threads : {1u, 2u, 3u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        results.push_back(trace(scene, &light, settings));
    }
    EXPECT_EQ(results[0].radiance.values, results[1].radiance.values);
    EXPECT_EQ(results[0].radiance.values, results[2].radiance.values);
    EXPECT_EQ(results[0].variance.values, results[1].variance.values);
    settings.seed = 5;
    EXPECT_NE(trace(scene, &light, settings).radiance.values, results[0].radiance.values);
}

} // namespace
} // namespace lambent::reference
