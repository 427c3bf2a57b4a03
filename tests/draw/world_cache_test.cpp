// The world cache by itself.
#include "draw/cpu/world_cache.h"

#include <gtest/gtest.h>

#include <tbb/parallel_for.h>

#include <cmath>
#include <random>
#include <vector>

namespace lambent::draw {
namespace {

CachePoint point_at(float x, float y, bool front = true)
{
    CachePoint point;
    point.position = {x, y, 0.0f};
    point.normal = {0.0f, 0.0f, 1.0f};
    point.front = front;
    return point;
}

CachedLight light_of(float unshadowed, float found)
{
    CachedLight light;
    light.unshadowed[diffuse_light] = glm::vec3(unshadowed);
    light.found[diffuse_light] = glm::vec3(found);
    return light;
}

const std::array<glm::vec3, light_classes> one_nit = {glm::vec3(1.0f), glm::vec3(0.0f)};

// The ratio of the sums, not the mean of the ratios: (0.1 + 0.9) / (1 + 3).
TEST(WorldCache, GivesTheRatioOfASum)
{
    WorldCache cache({1.0f, 0.01f});
    for (int i = 0; i < 32; ++i)
        cache.add(point_at(0.0f, 0.0f), i % 2 == 0 ? light_of(1.0f, 0.1f) : light_of(3.0f, 0.9f));
    EXPECT_NEAR(cache.true_light(point_at(0.0f, 0.0f), one_nit)[diffuse_light].g, 0.25f, 1e-5f);
    EXPECT_NEAR(cache.true_light(point_at(0.0f, 0.0f), {glm::vec3(4.0f), glm::vec3(0.0f)})[diffuse_light].g,
                1.0f, 1e-5f);
}

TEST(WorldCache, TellsTheSidesOfAWallApart)
{
    WorldCache cache({1.0f, 0.01f});
    for (int i = 0; i < 32; ++i) {
        cache.add(point_at(0.0f, 0.0f, true), light_of(1.0f, 1.0f));
        cache.add(point_at(0.0f, 0.0f, false), light_of(1.0f, 0.0f));
    }
    EXPECT_NEAR(cache.true_light(point_at(0.0f, 0.0f, true), one_nit)[diffuse_light].g, 1.0f, 1e-5f);
    EXPECT_NEAR(cache.true_light(point_at(0.0f, 0.0f, false), one_nit)[diffuse_light].g, 0.0f, 1e-5f);
}

// A place that no ray found takes the mean of its instance's side.
TEST(WorldCache, GuessesByTheInstance)
{
    WorldCache cache({1.0f, 0.01f});
    for (int i = 0; i < 32; ++i)
        cache.add(point_at(static_cast<float>(i % 8), 0.0f), light_of(1.0f, i % 2 == 0 ? 0.2f : 0.6f));
    cache.finish();
    EXPECT_NEAR(cache.true_light(point_at(500.0f, 40.0f), one_nit)[diffuse_light].g, 0.4f, 1e-5f);
}

// A corner that rays often meet is dark; the bright places beside it, each with few points, do not take part in that.
TEST(WorldCache, WidePlacesAreWithoutTheSmallOnesWithEnoughPoints)
{
    WorldCache cache({1.0f, 0.01f});
    for (int i = 0; i < 1000; ++i)
        cache.add(point_at(0.001f, 0.001f), light_of(1.0f, 0.1f));
    for (int i = 0; i < 20; ++i)
        cache.add(point_at(0.02f + 0.0015f * static_cast<float>(i), 0.03f), light_of(1.0f, 0.9f));
    cache.finish();
    EXPECT_NEAR(cache.true_light(point_at(0.001f, 0.001f), one_nit)[diffuse_light].g, 0.1f, 1e-5f);
    EXPECT_NEAR(cache.true_light(point_at(0.03f, 0.03f), one_nit)[diffuse_light].g, 0.9f, 1e-5f);
    EXPECT_NEAR(cache.true_light(point_at(0.04f, 0.01f), one_nit)[diffuse_light].g, 0.9f,
                1e-5f); // by no point
}

// Whatever the places have: at the points themselves the cache gives as much light in all as they have found. Places in
// thousands, as popular as different; one instance has so few points elsewhere that all of its points serve.
TEST(WorldCache, NeitherAddsNorLosesLight)
{
    std::mt19937 random(5);
    std::exponential_distribution<float> popular(40.0f), bright(1.0f);
    WorldCache cache({1.0f, 0.01f});
    std::vector<std::pair<CachePoint, float>> points;
    for (int i = 0; i < 20000; ++i) {
        CachePoint point = point_at(popular(random), popular(random));
        point.instance = i % 3 == 0 ? 1 : 0;
        point.normal = i % 5 < 3 ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::vec3(0.48f, 0.0f, 0.88f);
        points.emplace_back(point, (point.position.x + point.position.y) * bright(random));
        cache.add(point, light_of(1.0f, points.back().second));
    }
    cache.finish();
    double found = 0.0, known = 0.0;
    for (const auto& [point, light] : points) {
        found += static_cast<double>(light);
        known += static_cast<double>(cache.true_light(point, one_nit)[diffuse_light].g);
    }
    EXPECT_NEAR(known / found, 1.0, 0.01);
}

// Light of other surfaces alone, where nothing unshadowed arrives.
TEST(WorldCache, KeepsLightWithoutUnshadowedLight)
{
    WorldCache cache({1.0f, 0.01f});
    for (int i = 0; i < 32; ++i)
        cache.add(point_at(0.0f, 0.0f), light_of(0.0f, 2.5f));
    EXPECT_NEAR(cache.true_light(point_at(0.0f, 0.0f), {})[diffuse_light].g, 2.5f, 1e-5f);
}

TEST(WorldCache, AddsTheSameInAnyOrder)
{
    const auto filled = [](bool parallel) {
        auto cache = std::make_unique<WorldCache>(WorldCache::Sizes{1.0f, 0.01f});
        const auto add = [&](int i) {
            cache->add(
                point_at(0.001f * static_cast<float>(i % 50), 0.0f),
                light_of(1.0f + 0.37f * static_cast<float>(i % 7), 0.11f * static_cast<float>(i % 13)));
        };
        if (parallel)
            tbb::parallel_for(0, 20000, add);
        else
            for (int i = 20000; i-- > 0;)
                add(i);
        return cache;
    };
    const auto a = filled(true), b = filled(false);
    for (int i = 0; i < 50; ++i) {
        const CachePoint point = point_at(0.001f * static_cast<float>(i), 0.0f);
        EXPECT_EQ(a->true_light(point, one_nit)[diffuse_light].g,
                  b->true_light(point, one_nit)[diffuse_light].g);
    }
}

TEST(WorldCache, SaysWhenItIsFull)
{
    WorldCache cache({1.0f, 0.01f});
    EXPECT_FALSE(cache.is_full());
    for (int i = 0; i < 200000; ++i)
        cache.add(point_at(static_cast<float>(i), 1.0f), light_of(1.0f, 1.0f));
    EXPECT_TRUE(cache.is_full());
    EXPECT_NEAR(cache.true_light(point_at(3.0f, 1.0f), one_nit)[diffuse_light].g, 1.0f, 1e-5f);
}

TEST(WorldCache, SurvivesLightThatIsNotFinite)
{
    WorldCache cache({1.0f, 0.01f});
    cache.add(point_at(0.0f, 0.0f), light_of(NAN, INFINITY));
    cache.add(point_at(NAN, INFINITY), light_of(1.0f, 1.0f));
    EXPECT_TRUE(std::isfinite(cache.true_light(point_at(0.0f, 0.0f), one_nit)[diffuse_light].g));
}

} // namespace
} // namespace lambent::draw
