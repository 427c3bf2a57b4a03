// The rays that leave surfaces: which light each asks for, and how much of it reaches the viewer.
#include "draw/light/random_points.h"
#include "draw/cpu/ray_kernel.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace lambent::draw::testing {
namespace {

constexpr std::size_t count = 1 << 15;

void put(Fragments& f, int column, std::size_t at, const glm::vec3& v)
{
    for (int c = 0; c < 3; ++c)
        f[column + c][at] = v[c];
}

glm::vec3 get(const Fragments& f, int column, std::size_t at)
{
    return {f[column][at], f[column + 1][at], f[column + 2][at]};
}

struct Surface {
    glm::vec3 color{1.0f}, view{0.0f, 0.0f, 1.0f};
    float metallic = 0.0f, alpha = 0.25f, coat = 0.0f;
};

// Points with their normals along +Z, with evenly distributed random numbers.
Fragments points(const Surface& surface)
{
    Fragments f(all_ray_columns);
    f.resize(count);
    for (std::size_t at = 0; at < count; ++at) {
        for (int c = 0; c < column_count; ++c)
            f[c][at] = 0.0f;
        put(f, column_view, at, glm::normalize(surface.view));
        for (int lobe = 0; lobe <= layer_lobes; ++lobe)
            put(f, column_shine + columns_per_shine * lobe, at, {0.0f, 0.0f, 1.0f});
        put(f, column_base_color, at, surface.color);
        f[column_opacity][at] = f[column_occlusion][at] = f[column_lit][at] = 1.0f;
        f[column_metallic][at] = surface.metallic;
        f[column_alpha][at] = surface.alpha;
        f[column_coat][at] = surface.coat;
        f[column_coat_alpha][at] = 0.09f;
        for (int i = random_lobe; i < lobe_way; ++i)
            f[i][at] =
                random_number(7u, static_cast<std::uint32_t>(at), static_cast<std::size_t>(i - random_lobe));
    }
    return f;
}

struct Choosing {
    SampleTables tables = make_sample_tables(1);
    LightContext context;
    std::vector<LightSource> lights;

    explicit Choosing(const environment::Environment* environment)
    {
        context.environment = environment;
        context.tables = &tables;
    }
    void choose(Fragments& f) const { choose_rays(context, {lights, 4.0f}, 0, count, f); }
};

LightSource light_from(const glm::vec3& direction, float illuminance)
{
    LightSource light;
    light.axis = -glm::normalize(direction);
    light.intensity = glm::vec3(illuminance);
    return light;
}

// A white surface reflects all of a white environment's light: whatever the lobes and their chances, the mean of what a ray
// brings is 1. So is a coated one: its coat's share is what it takes from the base.
TEST(RayChoice, BringsTheAlbedo)
{
    for (const float metallic : {0.0f, 1.0f})
        for (const float alpha : {0.05f, 0.25f, 1.0f})
            for (const float coat : {0.0f, 1.0f})
                for (const glm::vec3 view : {glm::vec3(0.0f, 0.0f, 1.0f), glm::vec3(1.0f, 0.5f, 0.7f)}) {
                    Fragments f = points({glm::vec3(1.0f), view, metallic, alpha, coat});
                    Choosing(nullptr).choose(f);
                    double sum = 0.0;
                    for (std::size_t at = 0; at < count; ++at)
                        sum += static_cast<double>(f[lobe_diffuse][at] + f[lobe_glossy][at]) / count;
                    EXPECT_NEAR(sum, 1.0, 0.012) << metallic << ' ' << alpha << ' ' << coat << ' ' << view.x;
                }
}

// Each light is chosen as often as its share of all light, and then brings all of it.
TEST(RayChoice, ChoosesLightsByWhatTheySend)
{
    Choosing choosing(nullptr);
    const glm::vec3 ways[] = {
        {0.0f, 0.0f, 1.0f}, {0.6f, 0.0f, 0.8f}, {-0.6f, 0.0f, 0.8f}, {0.0f, 0.0f, -1.0f}};
    const float sizes[] = {1.0f, 2.0f, 4.0f, 100.0f}; // the last one is behind the surface
    for (int i = 0; i < 4; ++i)
        choosing.lights.push_back(light_from(ways[i], sizes[i]));
    Fragments f = points({glm::vec3(0.5f), {0.0f, 0.0f, 1.0f}, 0.0f, 1.0f, 0.0f});
    choosing.choose(f);
    // What each light alone brings.
    double alone[4] = {}, all = 0.0;
    for (int i = 0; i < 4; ++i) {
        Choosing one(nullptr);
        one.lights = {choosing.lights[static_cast<std::size_t>(i)]};
        Fragments g = points({glm::vec3(0.5f), {0.0f, 0.0f, 1.0f}, 0.0f, 1.0f, 0.0f});
        one.choose(g);
        alone[i] = static_cast<double>(g[light_diffuse][0] + g[light_glossy][0]);
        all += alone[i];
    }
    int chosen[4] = {};
    for (std::size_t at = 0; at < count; ++at) {
        EXPECT_NEAR(f[light_diffuse][at] + f[light_glossy][at], all, 1e-4 * all);
        for (int i = 0; i < 4; ++i)
            chosen[i] += glm::dot(get(f, light_way, at), ways[i]) > 0.999f;
    }
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(static_cast<double>(chosen[i]) / count, alone[i] / all, 0.004) << i;
    EXPECT_EQ(chosen[3], 0);
}

TEST(RayChoice, WithoutALightThereIsNoRay)
{
    Fragments f = points({});
    Choosing(nullptr).choose(f);
    EXPECT_EQ(f[light_distance][5], 0.0f);
    EXPECT_EQ(f[lamp_diffuse][5], 0.0f);
    EXPECT_EQ(f[lobe_radiance][5], 0.0f);
}

// The ray to a lamp points to where the lamp is in the world, at every rotation of the environment.
TEST(RayChoice, LampsTurnWithTheEnvironment)
{
    const glm::dvec3 lamp = glm::normalize(glm::dvec3(0.5, 0.3, 0.8));
    const environment::Environment environment = environment_of(
        256, [&](glm::dvec3 d) { return glm::vec3(glm::dot(d, lamp) > 0.999 ? 500.0f : 0.01f); });
    ASSERT_FALSE(environment.lamps.lamps.empty());
    for (const float turn : {0.0f, 0.4f, -0.7f}) {
        Choosing choosing(&environment);
        choosing.context.rotation_cosine = std::cos(turn);
        choosing.context.rotation_sine = std::sin(turn);
        Fragments f = points({glm::vec3(1.0f), {0.0f, 0.0f, 1.0f}, 0.0f, 1.0f, 0.0f});
        choosing.choose(f);
        // By view::Picture, the environment turns about +Y, counter-clockwise as seen from above.
        const glm::vec3 wanted(std::cos(turn) * lamp.x + std::sin(turn) * lamp.z, lamp.y,
                               std::cos(turn) * lamp.z - std::sin(turn) * lamp.x);
        glm::vec3 mean(0.0f);
        for (std::size_t at = 0; at < count; ++at)
            mean += get(f, lamp_way, at) / static_cast<float>(count);
        EXPECT_GT(glm::dot(glm::normalize(mean), wanted), 0.9995f) << turn;
    }
}

} // namespace
} // namespace lambent::draw::testing
