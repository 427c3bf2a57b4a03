// Whether what the tracer claims of its noise is true, wherever it stops.
#include "tests/reference/traced.h"

#include "environment/builtin/builtin.h"
#include "scene/builtin/builtin.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <array>

namespace lambent::reference {
namespace {

using namespace testing;

constexpr int width = 64, height = 36, truth_samples = 1024;
constexpr double cut = 1.0;

/// A scene under its light.
struct View {
    const char* name;
    scene::Scene scene;
    image::RadianceImage light;
    Settings settings;
};

Settings view_settings(const view::Camera& camera, int bounces)
{
    Settings settings;
    settings.width = width;
    settings.height = height;
    settings.camera = camera;
    settings.bounces = bounces;
    settings.cut = cut;
    return settings;
}

View builtin(const char* scene, const char* light)
{
    View view{scene, scene::make_builtin(scene), environment::make_builtin(light), {}};
    const view::Camera camera = view::orbit_camera(scene::framed_bounds(view.scene), {}, 0.7853982f,
                                                   static_cast<float>(width) / static_cast<float>(height));
    view.settings = view_settings(camera, 8);
    return view;
}

// A ball before a card, nothing behind: no light reaches the cut.
View ball_on_card()
{
    View view{"ball", scene_of(facing_square(0.8f, -0.5f), metallic(0.6f, 0.0f, 0.9f)), {}, {}};
    add(view.scene, scene::make_sphere(0.5f, 32, 16), metallic(0.8f, 1.0f, 0.4f));
    view.light = panorama_of(
        64, [](const glm::dvec3& d) { return glm::dvec3(0.3 + 0.3 * d.x, 0.3, 0.4 + 0.3 * d.y); });
    view.settings = view_settings(front_camera(2.0f), 2);
    view.settings.background.kind = view::Background::Kind::none;
    return view;
}

// A ball before a card in the light of a lamp, `half` of which is as many metres, `height` metres up: out of sight or not.
// Behind it, darkness.
View lamp(float half, float height)
{
    View view{"lamp", scene_of(facing_square(1.5f, -0.5f), metallic(0.7f, 0.0f, 0.8f)), {}, {}};
    add(view.scene, scene::make_sphere(0.4f, 32, 16), metallic(0.9f, 1.0f, 0.5f));
    scene::Material shining = metallic(0.0f, 0.0f, 1.0f);
    shining.emissive = glm::vec3(1.5f, 1.2f, 0.8f) / (half * half);
    shining.double_sided = true;
    scene::Mesh card = facing_square(half, 0.8f);
    for (glm::vec3& p : card.positions)
        p.y += height;
    add(view.scene, card, shining);
    view.light = panorama_of(16, [](const glm::dvec3&) { return glm::dvec3(0.0); });
    view.settings = view_settings(front_camera(2.0f), 4);
    view.settings.background.kind = view::Background::Kind::none;
    return view;
}

double cut_light(float value)
{
    return std::min(static_cast<double>(value), cut);
}

/// What a picture is off, and how well its claim can be known to be true, over all pixels or those that are covered.
struct Finding {
    double squares = 0.0; ///< sum of squared errors, without the truth's own
    double excess = 0.0;  ///< sum over values of what replicates say of them, less that
    double spread = 0.0;  ///< standard deviation of `excess`, were it 0 on average
    double at_cut =
        0.0; ///< part of `squares` that is at the cut or in pixels that only the truth knows as covered
    double truth = 0.0;  ///< relative RMSE
    double mean = 0.0;   ///< of the picture's own cut values, summed
    double values = 0.0; ///< that it counts
};

Finding find(const Result& result, const Result& truth, bool covered)
{
    Finding f;
    double light = 0.0, values = 0.0, squared_spread = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float *seen = result.radiance.pixel(x, y), *true_light = truth.radiance.pixel(x, y);
            const bool counts = !covered || seen[3] > 0.0f, should = !covered || true_light[3] > 0.0f;
            double excess = 0.0;
            for (int c = 0; c < 3; ++c) {
                const double a = cut_light(seen[c]), b = cut_light(true_light[c]);
                const double own = b < cut ? static_cast<double>(truth.variance.pixel(x, y)[c]) : 0.0;
                const double square = (a - b) * (a - b) - own;
                const bool certain = a < cut && b < cut && counts;
                if (should) {
                    f.squares += square;
                    f.at_cut += certain ? 0.0 : std::max(square, 0.0);
                    light += b;
                    values += 1.0;
                }
                if (certain && should)
                    excess += static_cast<double>(result.variance.pixel(x, y)[c]) - square;
                if (counts) {
                    f.mean += a;
                    f.values += 1.0;
                }
            }
            f.excess += excess;
            squared_spread += excess * excess;
        }
    f.spread = std::sqrt(squared_spread);
    f.truth = std::sqrt(f.squares / values) / (light / values);
    return f;
}

// Over many stops of a view.
struct Pool {
    int stops = 0;
    double excess = 0.0, variance = 0.0, least = 1e9, largest = 0.0;
};

// What every picture of these shows: a promise of the documentation. Over five deviations of `chance` for a picture with as
// few noisy pixels as these, with what cutting adds.
constexpr double least_ratio = 0.75, largest_ratio = 1.0 / least_ratio;

// What is claimed, squared, times what it is relative to, is the sum of what replicates say of all values. Where they are
// not cut that is right on average, and pixels are independent: the sum is off by no more than five deviations, which the
// pixels themselves show, whatever the law of their samples. At the cut it may be anything from nothing to twice.
void expect_true(double claim, const Finding& f, Pool& pool)
{
    const double said = f.values > 0.0 ? std::pow(claim * f.mean, 2) / f.values : 0.0;
    const double ratio = said / f.squares, chance = deviations * f.spread / f.squares,
                 cut_part = f.at_cut / f.squares;
    EXPECT_GT(ratio, 1.0 - chance - cut_part);
    EXPECT_LT(ratio, 1.0 + chance + cut_part);
    pool.least = std::min(pool.least, claim / f.truth);
    pool.largest = std::max(pool.largest, claim / f.truth);
    pool.excess += f.excess / f.squares;
    pool.variance += std::pow(f.spread / f.squares, 2);
    ++pool.stops;
}

/// Where to stop.
struct Stop {
    int samples = 96;
    bool adaptive = false;
    double noise = 0.0;
    int tiles = 0; ///< stopped after so many were done, counted over all rounds; 0: not
};

std::vector<Stop> stops(double noise_at_16)
{
    constexpr int tiles = ((width + 15) / 16) * ((height + 15) / 16);
    std::vector<Stop> all;
    for (const int samples : {2, 3, 4, 6, 8, 12, 16, 33, 64})
        all.push_back({samples});
    for (const int half_rounds : {5, 7, 9, 11})
        all.push_back({96, false, 0.0, half_rounds * tiles / 2});
    for (const int half_rounds : {11, 13})
        all.push_back({96, true, 0.0, half_rounds * tiles / 2});
    for (const int samples : {24, 48, 96})
        all.push_back({samples, true});
    for (const double part : {1.0, 0.8, 0.6})
        all.push_back({400, true, part * noise_at_16});
    return all;
}

Result trace_to(const View& view, const Stop& stop, std::uint32_t seed)
{
    Settings settings = view.settings;
    settings.seed = seed;
    settings.samples = stop.samples;
    settings.adaptive = stop.adaptive;
    settings.noise = stop.noise;
    int done = 0;
    return trace(view.scene, &view.light, settings,
                 [&](const Progress&) { return stop.tiles == 0 || ++done < stop.tiles; });
}

std::array<Pool, 2> expect_true_claims(const View& view, bool may_be_unknown = false)
{
    // Which tiles are done when it is stopped must not depend on threads.
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Result truth = trace_to(view, {truth_samples}, 999);
    const Result first = trace_to(view, {16}, 998);
    std::uint32_t seed = 0;
    std::array<Pool, 2> pools;
    for (const Stop& stop : stops(first.noise ? first.noise->covered : 0.5)) {
        const Result result = trace_to(view, stop, ++seed);
        SCOPED_TRACE(::testing::Message() << view.name << ": " << result.samples << " samples, adaptive "
                                          << stop.adaptive << ", noise " << stop.noise);
        if (!result.noise) {
            EXPECT_TRUE(may_be_unknown);
            continue;
        }
        expect_true(result.noise->all, find(result, truth, false), pools[0]);
        expect_true(result.noise->covered, find(result, truth, true), pools[1]);
    }
    for (const Pool& pool : pools) {
        EXPECT_GE(pool.stops, may_be_unknown ? 10 : 20);
        EXPECT_GT(pool.least, least_ratio);
        EXPECT_LT(pool.largest, largest_ratio);
    }
    return pools;
}

TEST(ReferenceClaims, AreTrueOfLightBelowTheCut)
{
    const Pool pool = expect_true_claims(ball_on_card())[0];
    // All stops together, which know it better than each.
    EXPECT_NEAR(pool.excess / pool.stops, 0.0, deviations * std::sqrt(pool.variance) / pool.stops);
}

TEST(ReferenceClaims, AreTrueOfARoomWithLampsInSight)
{
    expect_true_claims(builtin("report", "kitchen"));
}

TEST(ReferenceClaims, AreTrueOfMirroredLamps)
{
    expect_true_claims(builtin("grid", "studio"));
}

// The few pixels that see the lamp mirrored twice hold much of the noise: now and then too few.
TEST(ReferenceClaims, AreTrueOfALampAndItsShadows)
{
    expect_true_claims(lamp(0.15f, 1.2f), true);
}

// In sight, a lamp of a pixel outweighs the picture: its few pixels are off by chance, so that nothing true can be said.
// It is known when other pixels hold the noise.
TEST(ReferenceClaims, NothingIsClaimedOfOnePixelThatHoldsTheNoise)
{
    const View view = lamp(0.03f, 0.6f);
    for (const int samples : {2, 4, 8, 16})
        EXPECT_FALSE(trace_to(view, {samples}, 7).noise.has_value()) << samples;
}

} // namespace
} // namespace lambent::reference
