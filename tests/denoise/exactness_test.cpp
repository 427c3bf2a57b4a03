// What the filter must do exactly, or to the rounding of floats, with every instruction set.
#include "base/error.h"
#include "tests/denoise/pictures.h"
#include "tests/support/each_instruction_set.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace lambent::denoise::test {
namespace {

class LightFilter : public lambent::test::EachInstructionSet {};
LAMBENT_EACH_INSTRUCTION_SET(LightFilter);

void fill(Rgb& planes, float value)
{
    for (Plane& plane : planes)
        std::fill(plane.begin(), plane.end(), value);
}

void expect_near(const Rgb& found, const Rgb& expected, double relative)
{
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < found[c].size(); ++i)
            ASSERT_NEAR(found[c][i], expected[c][i],
                        relative * std::fabs(static_cast<double>(expected[c][i])))
                << "pixel " << i;
}

void expect_same(const Filtered& a, const Filtered& b)
{
    EXPECT_EQ(a.diffuse.light, b.diffuse.light);
    EXPECT_EQ(a.diffuse.gap, b.diffuse.gap);
    EXPECT_EQ(a.specular.light, b.specular.light);
    EXPECT_EQ(a.specular.gap, b.specular.gap);
}

TEST_P(LightFilter, ConstantLightPassesUnchanged)
{
    Picture picture = make_wall(75, 61);
    for (Light* light : {&picture.diffuse, &picture.specular}) {
        fill(light->exact, 0.7f);
        for (Half& half : light->halves) {
            fill(half.unshadowed, 0.7f);
            fill(half.found, 0.3f);
        }
    }
    const Filtered filtered = filter_light(picture, {});
    expect_near(filtered.diffuse.light, filled(75 * 61, 0.3f), 1e-6);
    expect_near(filtered.specular.light, filled(75 * 61, 0.3f), 1e-6);
}

TEST_P(LightFilter, WithoutShadowsTheResultIsTheExactLight)
{
    Picture picture = make_mixture(90, 70, 5);
    for (Light* light : {&picture.diffuse, &picture.specular})
        for (Half& half : light->halves)
            half.found = half.unshadowed;
    const Filtered filtered = filter_light(picture, {});
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < picture.count.size(); ++i) {
            const bool covered = picture.guides.coverage[i] > 0.0f;
            ASSERT_EQ(filtered.diffuse.light[c][i], covered ? picture.diffuse.exact[c][i] : 0.0f);
            ASSERT_EQ(filtered.specular.light[c][i], covered ? picture.specular.exact[c][i] : 0.0f);
            ASSERT_EQ(filtered.diffuse.gap[c][i], 0.0f);
        }
}

// Two halves of a picture in different light, told apart by one guide alone.
void expect_no_leak(const std::function<void(Guides& guides, std::size_t pixel)>& set_apart)
{
    Picture picture = make_wall(80, 40);
    Rgb expected = filled(80 * 40, 0.25f);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 80; ++x) {
            const std::size_t i = index_of(picture, x, y);
            const bool right = x >= 37;
            if (right)
                set_apart(picture.guides, i);
            for (std::size_t c = 0; c < 3; ++c) {
                expected[c][i] = right ? 8.0f : 0.25f;
                for (Light* light : {&picture.diffuse, &picture.specular}) {
                    light->exact[c][i] = 1.0f;
                    for (Half& half : light->halves) {
                        half.unshadowed[c][i] = 1.0f;
                        half.found[c][i] = expected[c][i];
                    }
                }
            }
        }
    const Filtered filtered = filter_light(picture, {1.0f, 16.0f});
    expect_near(filtered.diffuse.light, expected, 1e-6);
    expect_near(filtered.specular.light, expected, 1e-6);
}

TEST_P(LightFilter, NothingLeaksOverSteps)
{
    expect_no_leak([](Guides& guides, std::size_t i) { guides.depth[i] = 3.5f; });
    expect_no_leak([](Guides& guides, std::size_t i) {
        guides.normal[0][i] = 1.0f;
        guides.normal[2][i] = 0.0f;
    });
    expect_no_leak([](Guides& guides, std::size_t i) { guides.metalness[i] = 1.0f; });
    expect_no_leak([](Guides& guides, std::size_t i) { guides.alpha[i] = 1.0f; });
}

TEST_P(LightFilter, PixelsThatAreNotCoveredDoNotCount)
{
    Picture picture = make_mixture(90, 70, 7);
    const Filtered before = filter_light(picture, {});
    const auto spoil = [&](Plane& plane, float value) {
        for (std::size_t i = 0; i < plane.size(); ++i)
            if (picture.guides.coverage[i] == 0.0f)
                plane[i] = value;
    };
    const float nan = std::numeric_limits<float>::quiet_NaN(), huge = 1e30f;
    for (Plane* plane : {&picture.guides.depth, &picture.guides.alpha, &picture.guides.metalness,
                         &picture.count, &picture.guides.normal[0], &picture.guides.normal[1]})
        spoil(*plane, nan);
    for (Light* light : {&picture.diffuse, &picture.specular})
        for (Rgb* planes : {&light->exact, &light->halves[0].found, &light->halves[1].unshadowed})
            for (Plane& plane : *planes)
                spoil(plane, planes == &light->exact ? nan : huge);
    expect_same(before, filter_light(picture, {}));
}

TEST_P(LightFilter, IsLinearInTheScaleOfLight)
{
    Picture picture = make_mixture(90, 70, 9);
    const Filtered before = filter_light(picture, {1.0f, 2.0f});
    const auto scale = [](Rgb& planes) {
        for (Plane& plane : planes)
            for (float& value : plane)
                value *= 8.0f;
    };
    for (Light* light : {&picture.diffuse, &picture.specular}) {
        scale(light->exact);
        for (Half& half : light->halves) {
            scale(half.unshadowed);
            scale(half.found);
        }
    }
    Filtered after = filter_light(picture, {8.0f, 2.0f});
    Filtered expected = before;
    for (Rgb* planes :
         {&expected.diffuse.light, &expected.diffuse.gap, &expected.specular.light, &expected.specular.gap})
        scale(*planes);
    expect_same(expected, after);
}

TEST_P(LightFilter, SwappedHalvesGiveTheSamePicture)
{
    Picture picture = make_mixture(90, 70, 11);
    const Filtered before = filter_light(picture, {});
    std::swap(picture.diffuse.halves[0], picture.diffuse.halves[1]);
    std::swap(picture.specular.halves[0], picture.specular.halves[1]);
    Filtered after = filter_light(picture, {});
    for (FilteredLight* light : {&after.diffuse, &after.specular})
        for (Plane& plane : light->gap)
            for (float& value : plane)
                value = -value;
    expect_same(before, after);
}

// Pictures are cut into other tiles for other numbers of threads.
TEST(LightFilterOnce, AnyNumberOfThreadsGivesTheSameBytes)
{
    const Picture picture = make_mixture(650, 130, 13);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 7);
    tbb::task_arena one(1), many(7);
    const Filtered by_one = one.execute([&] { return filter_light(picture, {}); });
    expect_same(by_one, many.execute([&] { return filter_light(picture, {}); }));
}

TEST_P(LightFilter, NothingGivesNothing)
{
    const Filtered empty = filter_light(make_wall(0, 0), {});
    EXPECT_TRUE(empty.diffuse.light[0].empty());
    Picture black = make_wall(33, 21);
    black.diffuse.albedo = filled(33 * 21, 0.0f);
    for (float coverage : {1.0f, 0.0f}) {
        std::fill(black.guides.coverage.begin(), black.guides.coverage.end(), coverage);
        const Filtered filtered = filter_light(black, {});
        for (const FilteredLight* light : {&filtered.diffuse, &filtered.specular}) {
            EXPECT_EQ(light->light, filled(33 * 21, 0.0f));
            EXPECT_EQ(light->gap, filled(33 * 21, 0.0f));
        }
    }
    Picture zeros = black;
    for (Plane* plane : {&zeros.guides.depth, &zeros.guides.normal[2], &zeros.guides.alpha})
        std::fill(plane->begin(), plane->end(), 0.0f);
    std::fill(zeros.guides.coverage.begin(), zeros.guides.coverage.end(), 1.0f);
    EXPECT_EQ(filter_light(zeros, {}).specular.light, filled(33 * 21, 0.0f));
}

TEST(LightFilterOnce, PlanesOfAnotherSizeAreRefused)
{
    const Picture wall = make_wall(8, 8);
    Picture picture = wall;
    picture.guides.depth.pop_back();
    EXPECT_THROW(filter_light(picture, {}), Error);
    picture = wall;
    picture.specular.halves[1].found[2].push_back(0.0f);
    EXPECT_THROW(filter_light(picture, {}), Error);
    picture = wall;
    picture.diffuse.albedo[1].clear(); // of three planes, one is missing
    EXPECT_THROW(filter_light(picture, {}), Error);
    picture = wall;
    picture.width = -8;
    picture.height = -8;
    EXPECT_THROW(filter_light(picture, {}), Error);
}

} // namespace
} // namespace lambent::denoise::test
