// When the tracer stops, and what there is then.
#include "tests/reference/traced.h"

#include <tbb/global_control.h>

namespace lambent::reference {
namespace {

using namespace testing;

// Half of the picture is a wall, half is nothing; the light is noisy.
scene::Scene half_wall()
{
    scene::Mesh wall = facing_square(1.0f, 0.0f);
    for (glm::vec3& p : wall.positions)
        p.x += 1.0f;
    return scene_of(wall, metallic(0.7f, 0.0f, 0.9f));
}

image::RadianceImage noisy_light()
{
    return panorama_of(
        64, [](const glm::dvec3& d) { return glm::dvec3(d.y > 0.0 ? 1.0 + 3.0 * d.x * d.x : 0.2); });
}

TEST(ReferenceStopping, AtTheNumberOfSamples)
{
    const image::RadianceImage light = noisy_light();
    for (const int samples : {1, 2, 7, 8, 15, 16, 17, 100}) {
        const Result result = trace(half_wall(), &light, small_settings(20, 2.0f, samples));
        EXPECT_EQ(result.samples, samples);
        EXPECT_FALSE(result.stopped);
        EXPECT_EQ(result.radiance.width, 20);
        EXPECT_EQ(result.variance.channels, 3);
        ASSERT_EQ(result.noise.has_value(), samples > 1);
        if (samples > 1) {
            EXPECT_GT(result.noise->all, 0.0);
            EXPECT_GT(result.noise->covered, 0.0);
        }
    }
}

TEST(ReferenceStopping, AtTheNoise)
{
    const image::RadianceImage light = noisy_light();
    for (const bool adaptive : {false, true})
        for (const double noise : {0.05, 0.01}) {
            Settings settings = small_settings(32, 2.0f, 1 << 14);
            settings.noise = noise;
            settings.adaptive = adaptive;
            const Result result = trace(half_wall(), &light, settings);
            EXPECT_LE(result.noise.value().covered, noise);
            EXPECT_LT(result.samples, 1 << 13);
        }
}

// A wall that shines with (1, 2, 3), in every pixel.
void expect_plain(const Result& result)
{
    for (int y = 0; y < result.radiance.height; ++y)
        for (int x = 0; x < result.radiance.width; ++x) {
            EXPECT_EQ(result.radiance.pixel(x, y)[0], 1.0f);
            EXPECT_EQ(result.radiance.pixel(x, y)[1], 2.0f);
            EXPECT_EQ(result.radiance.pixel(x, y)[2], 3.0f);
            EXPECT_EQ(result.radiance.pixel(x, y)[3], 1.0f);
        }
}

TEST(ReferenceStopping, AtOnceWhenTheTimeIsUpButWithEveryPixel)
{
    const scene::Scene scene = scene_of(facing_square(5.0f, 0.0f), unlit({1.0f, 2.0f, 3.0f}));
    Settings settings = small_settings(48, 1.0f, 1 << 20);
    settings.seconds = 1e-9;
    const Result result = trace(scene, nullptr, settings);
    EXPECT_EQ(result.samples, 1.0);
    expect_plain(result);
}

TEST(ReferenceStopping, WhenAskedToButWithEveryPixel)
{
    const scene::Scene scene = scene_of(facing_square(5.0f, 0.0f), unlit({1.0f, 2.0f, 3.0f}));
    const Result result =
        trace(scene, nullptr, small_settings(48, 1.0f, 1 << 20), [](const Progress&) { return false; });
    EXPECT_TRUE(result.stopped);
    EXPECT_EQ(result.samples, 1.0);
    expect_plain(result);
}

// Within a round: some tiles have more samples than others, all of them are means.
TEST(ReferenceStopping, InTheMiddleTheMeansAreStillMeans)
{
    const scene::Scene scene = scene_of(facing_square(5.0f, 0.0f), unlit({1.0f, 2.0f, 3.0f}));
    int asked = 0;
    double last = 0.0;
    const Result result = trace(scene, nullptr, small_settings(48, 1.0f, 1 << 20), [&](const Progress& p) {
        EXPECT_GE(p.done, 0.0);
        EXPECT_LE(p.done, 1.0);
        EXPECT_GE(p.samples, last);
        last = p.samples;
        return ++asked < 40;
    });
    EXPECT_EQ(asked, 40);
    EXPECT_TRUE(result.stopped);
    EXPECT_GT(result.samples, 1.0);
    expect_light(result, {1.0, 2.0, 3.0}, 1e-6);
}

// Whole rounds of 1, 2, 4, 8 and 16 samples, then of ever more; nothing is said of the noise before the second.
TEST(ReferenceStopping, RoundsDoubleUntilTheNoiseIsKnownWell)
{
    const image::RadianceImage light = noisy_light();
    std::vector<double> samples;
    trace(half_wall(), &light, small_settings(20, 2.0f, 36), [&](const Progress& p) {
        if (samples.empty() || samples.back() != p.samples)
            samples.push_back(p.samples);
        EXPECT_EQ(p.noise.has_value(), p.samples >= 2.0);
        return true;
    });
    // Told at each tile with what the rounds before it came to.
    EXPECT_EQ(samples, (std::vector<double>{0.0, 1.0, 2.0, 4.0, 8.0, 16.0, 24.0}));
}

// Half of the second round: no band of tiles has two samples where another has one, and no noise is claimed.
TEST(ReferenceStopping, HalfARoundIsSpreadOverThePicture)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const image::RadianceImage light = noisy_light();
    int asked = 0;
    const Result result = trace(half_wall(), &light, small_settings(8 * Film::tile_size, 2.0f, 64),
                                [&](const Progress&) { return ++asked < 64 + 32; });
    EXPECT_EQ(result.samples, 1.5);
    EXPECT_FALSE(result.noise.has_value());
    for (int quarter = 0; quarter < 4; ++quarter) {
        int twice = 0;
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) {
                const int tile_x = 4 * (quarter % 2) + x, tile_y = 4 * (quarter / 2) + y;
                const float variance =
                    result.variance.pixel(tile_x * Film::tile_size, tile_y * Film::tile_size)[0];
                twice += std::isfinite(variance) ? 1 : 0;
            }
        EXPECT_EQ(twice, 8) << "quarter " << quarter;
    }
}

TEST(ReferenceStopping, NotBeforeTwoSamplesWhereTheVarianceIsWanted)
{
    const image::RadianceImage light = noisy_light();
    Settings settings = small_settings(48, 2.0f, 64);
    const Result refused = trace(
        half_wall(), &light, settings, [](const Progress&) { return false; }, Least::two_samples);
    EXPECT_TRUE(refused.stopped);
    EXPECT_EQ(refused.samples, 2.0);
    EXPECT_TRUE(refused.noise.has_value());
    settings.seconds = 1e-9;
    const Result late = trace(half_wall(), &light, settings, {}, Least::two_samples);
    EXPECT_EQ(late.samples, 2.0);
    EXPECT_TRUE(late.noise.has_value());
}

TEST(ReferenceStopping, AdaptiveAndUniformPicturesAgree)
{
    const image::RadianceImage light = noisy_light();
    Settings settings = small_settings(32, 2.0f, 512);
    const Result uniform = trace(half_wall(), &light, settings);
    settings.adaptive = true;
    settings.seed = 1;
    const Result adaptive = trace(half_wall(), &light, settings);
    EXPECT_NEAR(adaptive.samples, 512.0, 8.0);
    // The wall, to which samples move from where there is only darkness, is less noisy for it.
    for (int c = 0; c < 3; ++c) {
        const Average a = average(uniform, {16, 0, 16, 32}, c), b = average(adaptive, {16, 0, 16, 32}, c);
        EXPECT_NEAR(a.mean, b.mean, deviations * std::hypot(a.deviation, b.deviation));
        EXPECT_LT(b.deviation, 0.9 * a.deviation);
    }
}

// Nothing at all, and lit by nothing.
TEST(ReferenceStopping, AnEmptySceneIsBlack)
{
    scene::Scene scene;
    scene.materials.emplace_back();
    Settings settings = small_settings(17, 1.0f, 16);
    settings.noise = 0.01;
    const Result result = trace(scene, nullptr, settings);
    expect_light(result, glm::dvec3(0.0));
    EXPECT_EQ(result.noise.value().all, 0.0);
    EXPECT_EQ(result.noise->covered, 0.0);
}

// Told to stop at every turn, the tracer ends with the samples of one that was not: bit by bit.
void expect_same_in_pieces(const Settings& settings)
{
    const scene::Scene scene = scene_of(facing_square(3.0f, -0.5f), metallic(0.6f, 0.0f, 0.9f));
    const image::RadianceImage light =
        panorama_of(64, [](const glm::dvec3& d) { return glm::dvec3(1.0 + d.x, 1.0, 1.5 + d.y); });
    const Result whole = trace(scene, &light, settings);
    Tracing tracing(scene, &light, settings);
    int pieces = 0, blank = 0;
    for (bool finished = false; !finished; ++pieces) {
        finished = tracing.advance([](const Progress&) { return false; }, Least::nothing);
        if (tracing.has_picture()) {
            ASSERT_EQ(tracing.result().radiance.values.size(), whole.radiance.values.size());
        } else {
            ++blank;
        }
    }
    EXPECT_GT(pieces, 5);
    EXPECT_GT(blank, 0); // of nine tiles
    const Result result = tracing.result();
    EXPECT_EQ(result.radiance.values, whole.radiance.values);
    EXPECT_EQ(result.variance.values, whole.variance.values);
    EXPECT_EQ(result.samples, whole.samples);
    EXPECT_EQ(result.noise.value().all, whole.noise.value().all);
    EXPECT_EQ(result.noise->covered, whole.noise->covered);
}

TEST(ReferenceStopping, InPiecesItIsTheSame)
{
    Settings settings = small_settings(48, 2.0f, 64);
    settings.adaptive = true;
    expect_same_in_pieces(settings);
}

// Part of a round may look quiet enough where the whole is not, or is not reached: only whole rounds end it.
TEST(ReferenceStopping, InPiecesItEndsAtTheSameNoise)
{
    for (const double noise : {0.05, 0.04, 0.03, 0.025, 0.02, 0.015, 0.01}) {
        SCOPED_TRACE(noise);
        Settings settings = small_settings(48, 2.0f, 1 << 12);
        settings.adaptive = true;
        settings.noise = noise;
        expect_same_in_pieces(settings);
    }
}

} // namespace
} // namespace lambent::reference
