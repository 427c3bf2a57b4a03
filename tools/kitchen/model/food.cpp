// Fruit, bread and plants.
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

#include <cmath>

namespace lambent::kitchen {

void add_apple(const Site& site, const glm::vec3& tint)
{
    const glm::vec2 profile[] = {{0.0f, 0.008f},   {0.014f, 0.001f}, {0.028f, 0.010f}, {0.037f, 0.034f},
                                 {0.036f, 0.052f}, {0.024f, 0.068f}, {0.01f, 0.067f},  {0.0f, 0.058f}};
    site.lathe(Stuff::fruit, {smooth(profile, 3), 24, 1.2f}, tint);
    site.tube(Stuff::wood,
              {{{0.0f, 0.056f, 0.0f}, {0.003f, 0.07f, 0.0f}, {0.007f, 0.08f, 0.002f}}, {0.0016f}, 6},
              plan::walnut);
}

void add_lemon(const Site& site)
{
    // The lemon lies on its side.
    const glm::vec2 profile[] = {{0.0f, -0.045f}, {0.006f, -0.042f}, {0.014f, -0.034f}, {0.026f, -0.014f},
                                 {0.027f, 0.01f}, {0.016f, 0.033f},  {0.007f, 0.04f},   {0.0f, 0.043f}};
    site.at({0.0f, 0.028f, 0.0f})
        .tipped(88.0f)
        .lathe(Stuff::fruit, {smooth(profile, 3), 24, 1.2f}, {0.95f, 0.72f, 0.08f});
}

void add_orange(const Site& site)
{
    const glm::vec2 profile[] = {{0.0f, 0.0f},     {0.02f, 0.006f}, {0.035f, 0.022f}, {0.038f, 0.037f},
                                 {0.034f, 0.055f}, {0.02f, 0.07f},  {0.0f, 0.075f}};
    site.lathe(Stuff::fruit, {smooth(profile, 3), 28, 1.2f}, {0.95f, 0.38f, 0.04f});
    site.lathe(Stuff::leaf, {{{0.0f, 0.073f}, {0.004f, 0.0735f}, {0.003f, 0.077f}, {0.0f, 0.077f}}, 8},
               {0.2f, 0.3f, 0.1f});
}

void add_fruit_bowl(const Site& site)
{
    const glm::vec2 profile[] = {{0.0f, 0.0f},     {0.07f, 0.0f},   {0.075f, 0.01f}, {0.065f, 0.02f},
                                 {0.12f, 0.05f},   {0.165f, 0.1f},  {0.17f, 0.112f}, {0.163f, 0.11f},
                                 {0.115f, 0.058f}, {0.06f, 0.034f}, {0.0f, 0.03f}};
    site.lathe(Stuff::ceramic, {smooth(profile, 3), 48, 1.2f}, {0.20f, 0.33f, 0.42f});
    const glm::vec3 red(0.62f, 0.06f, 0.04f), green(0.42f, 0.56f, 0.10f);
    add_apple(site.at({0.06f, 0.045f, 0.03f}).tipped(14.0f), red);
    add_apple(site.at({-0.03f, 0.042f, 0.07f}, 50.0f).tipped(-10.0f), green);
    add_apple(site.at({-0.075f, 0.05f, -0.01f}, 130.0f).tipped(18.0f), red);
    add_orange(site.at({0.0f, 0.04f, -0.06f}));
    add_orange(site.at({0.075f, 0.055f, -0.055f}));
    add_orange(site.at({-0.005f, 0.10f, 0.01f}, 70.0f).tipped(20.0f));
    add_apple(site.at({-0.06f, 0.105f, -0.055f}, 80.0f).tipped(25.0f), green);
    add_lemon(site.at({0.055f, 0.115f, 0.045f}, 35.0f));
    add_lemon(site.at({-0.045f, 0.115f, 0.06f}, -50.0f));
    add_apple(site.at({0.05f, 0.112f, -0.03f}, 10.0f).tipped(-15.0f), red);
}

void add_cutting_board(const Site& site)
{
    site.box(Stuff::wood, {{-0.22f, 0.0f, -0.14f}, {0.22f, 0.024f, 0.14f}, 0.008f, 2, 0}, plan::walnut);
    // A loaf, slices, a tomato and a knife.
    std::vector<glm::vec3> loaf;
    std::vector<float> radii;
    for (int i = 0; i <= 14; ++i) {
        const float t = static_cast<float>(i) / 14.0f;
        loaf.push_back({-0.16f + 0.2f * t, 0.068f, -0.03f});
        radii.push_back(0.05f * std::pow(std::sin(3.0f * (0.02f + 0.98f * t) * 0.54f + 0.15f), 0.45f));
    }
    site.tube(Stuff::cloth, {loaf, radii, 24}, {0.50f, 0.27f, 0.10f});
    for (int i = 0; i < 2; ++i)
        site.at({0.07f + 0.045f * static_cast<float>(i), 0.03f + 0.006f * static_cast<float>(i), -0.03f})
            .lathe(
                Stuff::cloth,
                {{{0.0f, -0.005f}, {0.046f, -0.005f}, {0.048f, 0.0f}, {0.046f, 0.006f}, {0.0f, 0.006f}}, 24},
                {0.82f, 0.66f, 0.42f});
    add_apple(site.at({0.15f, 0.022f, 0.07f}, 40.0f), {0.70f, 0.07f, 0.03f});
    site.box(Stuff::steel, {{-0.14f, 0.0245f, 0.075f}, {0.04f, 0.0265f, 0.105f}, 0.0008f});
    site.box(Stuff::black, {{0.04f, 0.0245f, 0.079f}, {0.15f, 0.0385f, 0.101f}, 0.005f, 2});
}

namespace {

void add_pot(const Site& site, float radius, float height, const glm::vec3& tint)
{
    site.lathe(Stuff::ceramic,
               {{{0.0f, 0.0f},
                 {0.72f * radius, 0.0f},
                 {0.76f * radius, 0.01f},
                 {0.95f * radius, 0.96f * height},
                 {radius, height},
                 {0.9f * radius, height},
                 {0.87f * radius, 0.85f * height},
                 {0.0f, 0.85f * height}},
                36},
               tint);
    site.at({0.0f, 0.855f * height, 0.0f})
        .lathe(Stuff::cloth,
               {{{0.0f, -0.01f}, {0.86f * radius, -0.01f}, {0.86f * radius, 0.0f}, {0.0f, 0.01f}}, 24, 1.0f},
               {0.09f, 0.06f, 0.04f});
}

} // namespace

void add_herb(const Site& site)
{
    add_pot(site, 0.055f, 0.1f, {0.66f, 0.32f, 0.20f});
    for (int i = 0; i < 46; ++i) {
        const float turn = 360.0f * site.chance(), away = 0.038f * std::sqrt(site.chance());
        const float high = 0.085f + 0.13f * site.chance();
        const glm::vec3 green = (0.7f + 0.5f * site.chance()) * glm::vec3(0.20f, 0.40f, 0.09f);
        site.at({0.0f, 0.0f, 0.0f}, turn)
            .at({0.0f, high, away})
            .tipped(-40.0f + 50.0f * site.chance())
            .add(Stuff::leaf, make_leaf({0.05f, 0.03f, 0.9f, 4}), green);
    }
}

void add_tall_plant(const Site& site)
{
    add_pot(site, 0.2f, 0.36f, {0.86f, 0.84f, 0.80f});
    // Stalks that lean outwards, each with one large leaf.
    for (int i = 0; i < 22; ++i) {
        const Site side = site.at({0.0f, 0.28f, 0.0f}, 137.5f * static_cast<float>(i)); // the golden angle
        const float lean = 0.10f + 0.25f * site.chance(),
                    high = 0.45f + 0.04f * static_cast<float>(i) + 0.15f * site.chance();
        const glm::vec3 stalk[] = {
            {0.0f, 0.0f, 0.03f}, {0.0f, 0.5f * high, 0.05f + 0.2f * lean}, {0.0f, high, lean}};
        side.tube(Stuff::leaf, {smooth(stalk, 6), {0.006f}, 8}, {0.16f, 0.28f, 0.08f});
        const glm::vec3 green = (0.75f + 0.5f * site.chance()) * glm::vec3(0.11f, 0.27f, 0.07f);
        side.at({0.0f, high, lean})
            .tipped(-45.0f)
            .add(Stuff::leaf, make_leaf({0.42f, 0.2f, 1.7f, 12}), green);
    }
}

} // namespace lambent::kitchen
