// Two ways to the same light, and whether the tracer knows how wrong it is.
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

namespace lambent::reference {
namespace {

using namespace testing;

// A sphere on a square, under a bright spot and a gradient.
scene::Scene still_life()
{
    scene::Scene scene;
    add(scene, scene::make_sphere(0.4f, 64, 32), metallic({0.8f, 0.5f, 0.2f}, 0.6f, 0.7f));
    scene::Material ground = metallic({0.3f, 0.5f, 0.7f}, 0.0f, 0.9f);
    ground.double_sided = true;
    add(scene, scene::make_plane(1.5f, 1), ground,
        glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, -0.4f, 0.0f)));
    return scene;
}

image::RadianceImage soft_light()
{
    return panorama(64, [](glm::dvec3 d) {
        const double spot = std::exp(12.0 * (glm::dot(d, glm::normalize(glm::dvec3(0.6, 0.6, 0.5))) - 1.0));
        return glm::dvec3(0.2, 0.3, 0.4) * (1.2 + d.y) + 4.0 * spot;
    });
}

Settings view_of_it(int samples)
{
    Settings settings = front_view(16, 1.4f, samples);
    settings.camera = view::orbit_camera({glm::vec3(-0.8f), glm::vec3(0.8f)}, {0.4f, 0.5f, 0.0f}, 0.7f, 1.0f);
    settings.bounces = 3;
    return settings;
}

// Each pixel by each pair of strategies: 256 pixels x 3 pairs with 7 + 7 degrees of freedom. Beyond 8 standard errors
// such a t is 1.4e-6 of the time, so a false alarm comes about once in a thousand changes of the random numbers.
TEST(Estimators, AllFindTheSameLight)
{
    const scene::Scene scene = still_life();
    const image::RadianceImage light = soft_light();
    Settings settings = view_of_it(1024);
    std::vector<Result> results;
    for (Strategy strategy : {Strategy::both, Strategy::lights_only, Strategy::reflections_only}) {
        settings.strategy = strategy;
        ++settings.seed;
        results.push_back(trace(scene, &light, settings));
    }
    double noise[3] = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const Result &a = results[i], &b = results[(i + 1) % 3];
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const double variance = static_cast<double>(a.variance.pixel(x, y)[1]) +
                                        static_cast<double>(b.variance.pixel(x, y)[1]);
                const double apart =
                    static_cast<double>(a.radiance.pixel(x, y)[1] - b.radiance.pixel(x, y)[1]);
                EXPECT_LE(std::fabs(apart), 8.0 * std::sqrt(variance) + 1e-6) << i << ": " << x << ", " << y;
            }
        const Mean m = mean_of(a, 1), n = mean_of(b, 1);
        EXPECT_NEAR(m.value, n.value, most_sigmas * std::hypot(m.error, n.error));
        noise[i] = m.error;
    }
    // And together they are better than either.
    EXPECT_LT(noise[0], noise[1]);
    EXPECT_LT(noise[0], noise[2]);
}

// Of 200 runs: the variance of the values over the mean of the variances that the runs claimed, and the second moment of
// the standardised residuals.
struct Calibration {
    double variance_ratio = 0.0, second_moment = 0.0;
};

Calibration calibrate(const scene::Scene& scene, Settings settings)
{
    constexpr int runs = 200;
    const image::RadianceImage light = soft_light();
    std::vector<Result> results;
    for (int run = 0; run < runs; ++run) {
        settings.seed = static_cast<std::uint32_t>(run);
        results.push_back(trace(scene, &light, settings));
    }
    double spread = 0.0, claimed = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < results[0].variance.values.size(); ++i) {
        const auto value = [&](const Result& r) {
            return static_cast<double>(r.radiance.values[i / 3 * 4 + i % 3]);
        };
        double mean = 0.0;
        for (const Result& r : results)
            mean += value(r) / runs;
        for (const Result& r : results) {
            const double off = value(r) - mean, variance = static_cast<double>(r.variance.values[i]);
            spread += off * off / (runs - 1);
            claimed += variance / runs;
            moment += off * off / std::max(variance, 1e-12);
        }
    }
    moment /= runs * static_cast<double>(results[0].variance.values.size());
    std::printf("variance over the runs / claimed: %.3f; second moment of residuals: %.3f\n",
                spread / claimed, moment);
    return {spread / claimed, moment};
}

// Within a surface values are nearly normal: residuals are a t of 7 degrees of freedom, whose second moment is 7 / 5.
TEST(Estimators, VariancesAreTrue)
{
    Settings settings = front_view(8, 0.3f, 128);
    settings.bounces = 3;
    const Calibration c = calibrate(still_life(), settings);
    EXPECT_NEAR(c.variance_ratio, 1.0, 0.03);
    EXPECT_NEAR(c.second_moment, 1.4, 0.07);
}

// Where a pixel holds a sliver of something bright, residuals are far from normal; the variance is true all the same.
TEST(Estimators, VariancesAreTrueOnTheAverageAtEdgesToo)
{
    Settings settings = view_of_it(64);
    settings.width = settings.height = 8;
    EXPECT_NEAR(calibrate(still_life(), settings).variance_ratio, 1.0, 0.08);
}

TEST(Estimators, AdaptiveAndUniformAgree)
{
    const scene::Scene scene = still_life();
    const image::RadianceImage light = soft_light();
    Settings settings = view_of_it(512);
    settings.width = settings.height = 48;
    const Mean uniform = mean_of(trace(scene, &light, settings));
    settings.adaptive = true;
    settings.seed = 1;
    const Result adaptive = trace(scene, &light, settings);
    const Mean m = mean_of(adaptive);
    EXPECT_NEAR(m.value, uniform.value, most_sigmas * std::hypot(m.error, uniform.error));
    EXPECT_NEAR(adaptive.samples, 512.0, 16.0);
}

TEST(Estimators, TheNoiseItStopsAtIsTheErrorItHas)
{
    const scene::Scene scene = still_life();
    const image::RadianceImage light = soft_light();
    Settings settings = view_of_it(1 << 14);
    const Result exact = trace(scene, &light, settings);
    settings.noise = 0.02;
    settings.adaptive = true;
    settings.seed = 9;
    const Result quick = trace(scene, &light, settings);
    EXPECT_LE(quick.noise, 0.02);
    EXPECT_LT(quick.samples, 4096.0);
    double squares = 0.0, sum = 0.0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c) {
                squares += std::pow(
                    static_cast<double>(quick.radiance.pixel(x, y)[c] - exact.radiance.pixel(x, y)[c]), 2);
                sum += static_cast<double>(exact.radiance.pixel(x, y)[c]);
            }
    const double error = std::sqrt(squares / 768.0) / (sum / 768.0);
    EXPECT_NEAR(error / quick.noise, 1.0, 0.25);
}

} // namespace
} // namespace lambent::reference
