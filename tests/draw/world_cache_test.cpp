// The cache of light by itself: cells, sums and rounds.
#include "draw/light/cache_rounds.h"

#include <gtest/gtest.h>

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

// A cache in the making.
class Places {
public:
    void add(const CachePoint& point, const CachedLight& light)
    {
        samples_.emplace_back();
        samples_.back().place = point;
        samples_.back().light = light;
    }
    // With a ray to a further place, of whose light it sends a share on.
    void add(const CachePoint& point, const CachedLight& light, const CachePoint& further, float share)
    {
        add(point, light);
        PlaceSample& sample = samples_.back();
        sample.has_further = true;
        sample.further = further;
        sample.further_light[diffuse_light] = glm::vec3(1.0f);
        sample.share[diffuse_light] = glm::vec3(share);
    }
    std::shared_ptr<const WorldCache> fill(int rounds = 1) const
    {
        return fill_cache({samples_}, {}, rounds);
    }
    const std::vector<PlaceSample>& samples() const { return samples_; }

private:
    std::vector<PlaceSample> samples_;
};

const std::array<glm::vec3, light_classes> one_nit = {glm::vec3(1.0f), glm::vec3(0.0f)};

// The ratio of the sums, not the mean of the ratios: (0.1 + 0.9) / (1 + 3).
TEST(WorldCache, GivesTheRatioOfASum)
{
    Places places;
    for (int i = 0; i < 32; ++i)
        places.add(point_at(0.0f, 0.0f), i % 2 == 0 ? light_of(1.0f, 0.1f) : light_of(3.0f, 0.9f));
    const std::shared_ptr<const WorldCache> cache = places.fill();
    EXPECT_NEAR(cache->true_light(point_at(0.0f, 0.0f), one_nit)[diffuse_light].g, 0.25f, 1e-5f);
    EXPECT_NEAR(cache->true_light(point_at(0.0f, 0.0f), {glm::vec3(4.0f), glm::vec3(0.0f)})[diffuse_light].g,
                1.0f, 1e-5f);
}

TEST(WorldCache, TellsTheSidesOfAWallApart)
{
    Places places;
    for (int i = 0; i < 32; ++i) {
        places.add(point_at(0.0f, 0.0f, true), light_of(1.0f, 1.0f));
        places.add(point_at(0.0f, 0.0f, false), light_of(1.0f, 0.0f));
    }
    const std::shared_ptr<const WorldCache> cache = places.fill();
    EXPECT_NEAR(cache->true_light(point_at(0.0f, 0.0f, true), one_nit)[diffuse_light].g, 1.0f, 1e-5f);
    EXPECT_NEAR(cache->true_light(point_at(0.0f, 0.0f, false), one_nit)[diffuse_light].g, 0.0f, 1e-5f);
}

// A place that no ray found takes the mean of its instance's side.
TEST(WorldCache, GuessesByTheInstance)
{
    Places places;
    for (int i = 0; i < 32; ++i)
        places.add(point_at(static_cast<float>(i % 8), 0.0f), light_of(1.0f, i % 2 == 0 ? 0.2f : 0.6f));
    const std::shared_ptr<const WorldCache> cache = places.fill();
    EXPECT_NEAR(cache->true_light(point_at(500.0f, 40.0f), one_nit)[diffuse_light].g, 0.4f, 1e-5f);
}

// A corner that rays often meet is dark; the bright places beside it, each with few points, do not take part in that.
TEST(WorldCache, WidePlacesAreWithoutTheSmallOnesWithEnoughPoints)
{
    Places places;
    for (int i = 0; i < 1000; ++i)
        places.add(point_at(0.001f, 0.001f), light_of(1.0f, 0.1f));
    for (int i = 0; i < 20; ++i)
        places.add(point_at(0.02f + 0.0015f * static_cast<float>(i), 0.03f), light_of(1.0f, 0.9f));
    const std::shared_ptr<const WorldCache> cache = places.fill();
    EXPECT_NEAR(cache->true_light(point_at(0.001f, 0.001f), one_nit)[diffuse_light].g, 0.1f, 1e-5f);
    EXPECT_NEAR(cache->true_light(point_at(0.03f, 0.03f), one_nit)[diffuse_light].g, 0.9f, 1e-5f);
    EXPECT_NEAR(cache->true_light(point_at(0.04f, 0.01f), one_nit)[diffuse_light].g, 0.9f,
                1e-5f); // by no point
}

// Whatever the places have: at the points themselves the cache gives as much light in all as they have found. Places in
// thousands, as popular as different; one instance has so few points elsewhere that all of its points serve.
TEST(WorldCache, NeitherAddsNorLosesLight)
{
    std::mt19937 random(5);
    std::exponential_distribution<float> popular(40.0f), bright(1.0f);
    Places places;
    std::vector<std::pair<CachePoint, float>> points;
    for (int i = 0; i < 20000; ++i) {
        CachePoint point = point_at(popular(random), popular(random));
        point.instance = i % 3 == 0 ? 1 : 0;
        point.normal = i % 5 < 3 ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::vec3(0.48f, 0.0f, 0.88f);
        points.emplace_back(point, (point.position.x + point.position.y) * bright(random));
        places.add(point, light_of(1.0f, points.back().second));
    }
    const std::shared_ptr<const WorldCache> cache = places.fill();
    double found = 0.0, known = 0.0;
    for (const auto& [point, light] : points) {
        found += static_cast<double>(light);
        known += static_cast<double>(cache->true_light(point, one_nit)[diffuse_light].g);
    }
    EXPECT_NEAR(known / found, 1.0, 0.01);
}

// Light of other surfaces alone, where nothing unshadowed arrives.
TEST(WorldCache, KeepsLightWithoutUnshadowedLight)
{
    Places places;
    for (int i = 0; i < 32; ++i)
        places.add(point_at(0.0f, 0.0f), light_of(0.0f, 2.5f));
    const std::shared_ptr<const WorldCache> cache = places.fill();
    EXPECT_NEAR(cache->true_light(point_at(0.0f, 0.0f), {})[diffuse_light].g, 2.5f, 1e-5f);
}

TEST(WorldCache, AddsTheSameInAnyOrder)
{
    std::vector<std::vector<PlaceSample>> forward(200), backward(1);
    Places places;
    for (int i = 0; i < 20000; ++i)
        places.add(point_at(0.001f * static_cast<float>(i % 50), 0.0f),
                   light_of(1.0f + 0.37f * static_cast<float>(i % 7), 0.11f * static_cast<float>(i % 13)),
                   point_at(0.001f * static_cast<float>(i % 31), 0.0f), 0.5f);
    for (std::size_t i = 0; i < places.samples().size(); ++i)
        forward[i % 200].push_back(places.samples()[i]);
    backward[0].assign(places.samples().rbegin(), places.samples().rend());
    const auto a = fill_cache(forward, {}, 4), b = fill_cache(backward, {}, 4);
    for (int i = 0; i < 50; ++i) {
        const CachePoint point = point_at(0.001f * static_cast<float>(i), 0.0f);
        EXPECT_EQ(a->true_light(point, one_nit)[diffuse_light].g,
                  b->true_light(point, one_nit)[diffuse_light].g);
    }
}

// Two walls that see each other and send half of what they get: 1 + 1/2 + 1/4 ...; rounds end where no light comes.
TEST(WorldCache, EachRoundAddsABounce)
{
    Places places;
    for (int i = 0; i < 64; ++i) {
        places.add(point_at(0.0f, 0.0f), light_of(1.0f, 1.0f), point_at(50.0f, 0.0f), 0.5f);
        places.add(point_at(50.0f, 0.0f), light_of(1.0f, 1.0f), point_at(0.0f, 0.0f), 0.5f);
    }
    for (const int rounds : {1, 2, 3, 4})
        EXPECT_NEAR(places.fill(rounds)->true_light(point_at(0.0f, 0.0f), one_nit)[diffuse_light].g,
                    2.0f - std::ldexp(1.0f, 1 - rounds), 1e-5f);
    EXPECT_NEAR(places.fill(1000)->true_light(point_at(0.0f, 0.0f), one_nit)[diffuse_light].g, 2.0f, 3e-3f);
}

// More places than there can be cells: wider ones hold them.
TEST(WorldCache, HoldsAnyNumberOfPlaces)
{
    CacheCells cells(0.01f);
    for (int i = 0; i < 400000; ++i)
        cells.count(point_at(static_cast<float>(i), 1.0f));
    EXPECT_TRUE(cells.is_full());
    Places places;
    for (int i = 0; i < 400000; ++i)
        places.add(point_at(static_cast<float>(i), 1.0f), light_of(1.0f, i < 200000 ? 0.25f : 0.75f));
    const std::shared_ptr<const WorldCache> cache = places.fill();
    EXPECT_FALSE(cache->cells().is_full());
    EXPECT_NEAR(cache->true_light(point_at(100000.0f, 1.0f), one_nit)[diffuse_light].g, 0.25f, 1e-5f);
    EXPECT_NEAR(cache->true_light(point_at(300000.0f, 1.0f), one_nit)[diffuse_light].g, 0.75f, 1e-5f);
}

// Nothing is known: the light is without shadows.
TEST(WorldCache, WithoutPlacesThereIsNoShadow)
{
    EXPECT_EQ(Places().fill()->true_light(point_at(0.0f, 0.0f), one_nit)[diffuse_light].g, 1.0f);
}

TEST(WorldCache, SurvivesLightThatIsNotFinite)
{
    Places places;
    places.add(point_at(0.0f, 0.0f), light_of(NAN, INFINITY));
    places.add(point_at(NAN, INFINITY), light_of(1.0f, 1.0f));
    const std::shared_ptr<const WorldCache> cache = places.fill();
    EXPECT_TRUE(std::isfinite(cache->true_light(point_at(0.0f, 0.0f), one_nit)[diffuse_light].g));
}

} // namespace
} // namespace lambent::draw
