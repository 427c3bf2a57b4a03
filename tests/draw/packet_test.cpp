// Rays that Embree would end the program over, and short packets, with every instruction set that it has.
#include "trace/visibility.h"
#include "tests/draw/test_scenes.h"
#include "tests/support/each_instruction_set.h"

#include <gtest/gtest.h>

#include <limits>

namespace lambent::draw {
namespace {

using trace::Hit, trace::Ray, trace::Rays, trace::Visibility;

constexpr float infinity = std::numeric_limits<float>::infinity(),
                no_number = std::numeric_limits<float>::quiet_NaN();

class Packets : public test::EachInstructionSet {};

Rays rays_of(const std::vector<Ray>& list)
{
    Rays rays;
    rays.resize(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            rays.origin[axis][i] = list[i].origin[axis];
            rays.direction[axis][i] = list[i].direction[axis];
        }
        rays.near[i] = list[i].near;
    }
    return rays;
}

std::vector<Hit> traced(const Visibility& visibility, const std::vector<Ray>& list)
{
    std::vector<Hit> hits(list.size());
    visibility.trace(rays_of(list), hits.data());
    return hits;
}

// Down on a place of the plane z = 0 from a height above it.
Ray down(float x, float height)
{
    return {{x, 0.0f, height}, {0.0f, 0.0f, -1.0f}};
}

// What is no ray to Embree.
std::vector<Ray> impossible()
{
    std::vector<Ray> list;
    for (const float bad : {no_number, infinity, -infinity, 2.0e18f, -3.0e38f})
        for (int axis = 0; axis < 3; ++axis) {
            list.push_back(down(0.0f, 1.0f)), list.back().origin[axis] = bad;
            list.push_back(down(0.0f, 1.0f)), list.back().direction[axis] = bad;
        }
    for (const float near : {no_number, -1.0f, -infinity})
        list.push_back(down(0.0f, 1.0f)), list.back().near = near;
    return list;
}

TEST_P(Packets, OfAnyLengthMeetThePlane)
{
    scene::Scene scene;
    testing::add(scene, testing::facing_square(1.0f, 0.0f), testing::matte({1, 1, 1}));
    const Visibility visibility(scene);
    for (std::size_t count = 1; count <= 35; ++count) {
        std::vector<Ray> list;
        for (std::size_t i = 0; i < count; ++i)
            list.push_back(down(i % 3 == 2 ? 1.5f : -0.9f + 0.05f * static_cast<float>(i),
                                1.0f + 0.5f * static_cast<float>(i)));
        const std::vector<Hit> hits = traced(visibility, list);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(hits[i].found(), i % 3 != 2) << i << " of " << count;
            if (hits[i].found()) {
                EXPECT_FLOAT_EQ(hits[i].distance, list[i].origin.z) << i << " of " << count;
            }
        }
    }
}

TEST_P(Packets, ImpossibleRaysMeetNothingAndHarmNoOthers)
{
    scene::Scene scene;
    testing::add(scene, testing::facing_square(1.0f, 0.0f), testing::matte({1, 1, 1}));
    const Visibility visibility(scene);
    const std::vector<Ray> bad = impossible();
    std::vector<Ray> list;
    for (const Ray& ray : bad)
        list.push_back(ray), list.push_back(down(0.25f, 2.0f));
    list.insert(list.end(), bad.begin(), bad.end()); // whole packets of them, too
    const std::vector<Hit> hits = traced(visibility, list);
    for (std::size_t i = 0; i < list.size(); ++i)
        EXPECT_EQ(hits[i].found(), i % 2 == 1 && i < 2 * bad.size()) << i;
    for (const Ray& ray : bad)
        EXPECT_FALSE(visibility.nearest(ray).found());
    for (const float far : {no_number, -1.0f, 0.5f}) {
        Ray ray = down(0.0f, 1.0f);
        ray.far = far;
        EXPECT_FALSE(visibility.nearest(ray).found()) << far;
    }
    EXPECT_TRUE(visibility.nearest(down(0.0f, 1.0f)).found());
}

TEST_P(Packets, ASceneOfNothingIsMetByNothing)
{
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.meshes.emplace_back();
    scene.instances.push_back({0, -1, glm::mat4(1.0f)});
    const Visibility visibility(scene);
    for (const Hit& hit : traced(visibility, {5, down(0.0f, 1.0f)}))
        EXPECT_FALSE(hit.found());
    EXPECT_FALSE(visibility.nearest(down(0.0f, 1.0f)).found());
}

// Into the space of such meshes no ray can be turned: the inverse overflows, or there is none.
TEST_P(Packets, MeshesShownTwiceMayBeFlatTinyOrHuge)
{
    constexpr float tiny = 1e-13f, tinier = 1e-25f, huge = 1e14f;
    const struct {
        glm::vec3 scale;
        bool is_met;
    } cases[] = {{{1, 1, 0}, true},          {{0, 1, 1}, false},         {{0, 0, 0}, false},
                 {{tiny, tiny, tiny}, true}, {{1, 1, tinier}, true},     {{tinier, tinier, tinier}, false},
                 {{huge, huge, huge}, true}, {{1.0f, huge, huge}, true}, {{1e-3f, 1e-3f, 1e-3f}, true}};
    for (const auto& [scale, is_met] : cases) {
        scene::Scene scene;
        testing::add(scene, testing::facing_square(1.0f, 0.0f), testing::matte({1, 1, 1}));
        scene.instances.push_back(
            {0, -1, glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, -3.0f)), scale)});
        const Visibility visibility(scene);
        // Past the first square only the second is there.
        Ray past = down(1e-14f, 1.0f);
        past.near = 2.0f;
        for (const Hit& hit : traced(visibility, {7, past})) {
            ASSERT_EQ(hit.found(), is_met) << scale.x << " " << scale.y << " " << scale.z;
            if (is_met) {
                EXPECT_EQ(hit.instance, 1u);
                EXPECT_FLOAT_EQ(hit.distance, 4.0f);
                EXPECT_FLOAT_EQ(hit.normal.z, 1.0f);
            }
        }
        EXPECT_EQ(visibility.nearest(past).found(), is_met);
        EXPECT_TRUE(visibility.nearest(down(0.0f, 1.0f)).found());
    }
}

LAMBENT_EACH_INSTRUCTION_SET(Packets);

} // namespace
} // namespace lambent::draw
