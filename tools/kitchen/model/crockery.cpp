// Plates, cups, bottles, pots and other objects on worktops.
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

#include <cmath>

namespace lambent::kitchen {
namespace {

// An ear-shaped handle in the plane of +X and +Y, from `low` to `high` on a wall of this radius.
struct Ear {
    float radius, low, high;
};

void add_ear(const Site& site, const Ear& ear, const glm::vec3& tint)
{
    const float size = ear.high - ear.low, out = 0.75f * size;
    const glm::vec3 points[] = {{ear.radius - 0.002f, ear.high, 0.0f},
                                {ear.radius + 0.7f * out, ear.high - 0.1f * size, 0.0f},
                                {ear.radius + out, 0.5f * (ear.low + ear.high), 0.0f},
                                {ear.radius + 0.6f * out, ear.low + 0.1f * size, 0.0f},
                                {ear.radius - 0.004f, ear.low, 0.0f}};
    site.tube(Stuff::ceramic, {smooth(points, 6), {0.09f * size + 0.0015f}, 10}, tint);
}

} // namespace

void add_plate(const Site& site, const glm::vec3& tint)
{
    const glm::vec2 profile[] = {{0.0f, 0.003f},   {0.07f, 0.003f},  {0.075f, 0.0f},   {0.08f, 0.003f},
                                 {0.105f, 0.010f}, {0.134f, 0.019f}, {0.135f, 0.022f}, {0.104f, 0.015f},
                                 {0.08f, 0.008f},  {0.0f, 0.007f}};
    site.lathe(Stuff::ceramic, {{std::begin(profile), std::end(profile)}, 36, 1.2f}, tint);
}

void add_bowl(const Site& site, const glm::vec3& tint)
{
    const glm::vec2 profile[] = {{0.0f, 0.004f},   {0.035f, 0.004f}, {0.037f, 0.0f},  {0.042f, 0.002f},
                                 {0.062f, 0.018f}, {0.076f, 0.045f}, {0.08f, 0.07f},  {0.078f, 0.072f},
                                 {0.072f, 0.046f}, {0.057f, 0.021f}, {0.03f, 0.009f}, {0.0f, 0.008f}};
    site.lathe(Stuff::ceramic, {{std::begin(profile), std::end(profile)}, 32, 1.2f}, tint);
}

void add_cup(const Site& site, const glm::vec3& tint)
{
    const glm::vec2 profile[] = {{0.0f, 0.003f},   {0.03f, 0.0f},   {0.036f, 0.004f}, {0.041f, 0.03f},
                                 {0.042f, 0.088f}, {0.040f, 0.09f}, {0.038f, 0.086f}, {0.037f, 0.03f},
                                 {0.03f, 0.009f},  {0.0f, 0.008f}};
    site.lathe(Stuff::ceramic, {{std::begin(profile), std::end(profile)}, 28, 1.0f}, tint);
    add_ear(site, {0.041f, 0.02f, 0.075f}, tint);
}

void add_bottle(const Site& site, const glm::vec3& tint)
{
    const glm::vec2 profile[] = {{0.0f, 0.0f},    {0.032f, 0.0f},   {0.037f, 0.006f},
                                 {0.037f, 0.19f}, {0.032f, 0.215f}, {0.017f, 0.24f},
                                 {0.014f, 0.26f}, {0.0135f, 0.30f}, {0.0f, 0.30f}};
    site.lathe(Stuff::glass, {{std::begin(profile), std::end(profile)}, 24, 0.9f}, tint);
    site.lathe(Stuff::wood, {{{0.0f, 0.295f}, {0.011f, 0.295f}, {0.013f, 0.325f}, {0.0f, 0.327f}}, 16},
               plan::pale_oak);
    site.lathe(Stuff::cloth, {{{0.0375f, 0.06f}, {0.0378f, 0.06f}, {0.0378f, 0.15f}, {0.0375f, 0.15f}}, 24},
               plan::white);
}

void add_jar(const Site& site, const glm::vec3& content)
{
    site.lathe(
        Stuff::glass,
        {{{0.0f, 0.0f}, {0.047f, 0.0f}, {0.052f, 0.006f}, {0.052f, 0.15f}, {0.046f, 0.162f}, {0.0f, 0.162f}},
         28},
        content);
    site.lathe(Stuff::wood,
               {{{0.0f, 0.16f}, {0.049f, 0.16f}, {0.05f, 0.185f}, {0.046f, 0.19f}, {0.0f, 0.19f}}, 28},
               plan::pale_oak);
}

void add_vase(const Site& site, const glm::vec3& tint)
{
    const glm::vec2 outside[] = {{0.0f, 0.0f},     {0.055f, 0.0f},   {0.06f, 0.01f},  {0.085f, 0.09f},
                                 {0.08f, 0.16f},   {0.042f, 0.235f}, {0.036f, 0.27f}, {0.042f, 0.30f},
                                 {0.036f, 0.298f}, {0.03f, 0.26f},   {0.0f, 0.2f}};
    site.lathe(Stuff::ceramic, {smooth(outside, 3), 36, 1.0f}, tint);
    // Long leaves on thin stalks.
    for (int i = 0; i < 9; ++i) {
        const float turn = 40.0f * static_cast<float>(i) + 20.0f * site.chance(),
                    lean = 0.10f + 0.13f * site.chance();
        const float high = 0.5f + 0.2f * site.chance();
        const Site branch = site.at({0.0f, 0.0f, 0.0f}, turn);
        const glm::vec3 stalk[] = {{0.0f, 0.2f, 0.0f},
                                   {0.0f, 0.32f, 0.03f},
                                   {0.0f, 0.5f * (0.32f + high), 0.4f * lean + 0.02f},
                                   {0.0f, high, lean}};
        const std::vector<glm::vec3> path = smooth(stalk, 5);
        branch.tube(Stuff::leaf, {path, {0.0022f}, 6}, {0.22f, 0.26f, 0.12f});
        for (std::size_t k = 6; k < path.size(); ++k)
            for (const float side : {-75.0f, 75.0f})
                branch.at(path[k], side + 30.0f * site.chance())
                    .tipped(-25.0f)
                    .add(Stuff::leaf, make_leaf({0.055f, 0.03f, 0.5f, 4}), {0.30f, 0.42f, 0.27f});
    }
}

void add_pot_with_lid(const Site& site)
{
    site.lathe(Stuff::steel, {{{0.0f, 0.0f},
                               {0.1f, 0.0f},
                               {0.107f, 0.007f},
                               {0.107f, 0.125f},
                               {0.11f, 0.128f},
                               {0.109f, 0.134f},
                               {0.09f, 0.146f},
                               {0.04f, 0.155f},
                               {0.0f, 0.157f}},
                              40});
    site.lathe(
        Stuff::black,
        {{{0.0f, 0.15f}, {0.012f, 0.15f}, {0.01f, 0.17f}, {0.02f, 0.178f}, {0.018f, 0.186f}, {0.0f, 0.188f}},
         20});
    for (const float turn : {0.0f, 180.0f}) {
        const glm::vec3 points[] = {
            {0.1f, 0.1f, -0.04f}, {0.15f, 0.1f, -0.04f}, {0.15f, 0.1f, 0.04f}, {0.1f, 0.1f, 0.04f}};
        site.at(glm::vec3(0.0f), turn).tube(Stuff::steel, {rounded_path(points, 0.02f, 5), {0.006f}, 10});
    }
}

void add_kettle(const Site& site)
{
    const glm::vec2 body[] = {
        {0.095f, 0.012f}, {0.104f, 0.04f}, {0.1f, 0.1f}, {0.082f, 0.16f}, {0.055f, 0.195f}};
    site.lathe(Stuff::black, {{{0.0f, 0.0f}, {0.095f, 0.0f}, {0.095f, 0.012f}, {0.0f, 0.012f}}, 40});
    site.lathe(Stuff::steel, {smooth(body, 6), 44});
    site.lathe(Stuff::steel, {{{0.055f, 0.195f}, {0.05f, 0.203f}, {0.02f, 0.21f}, {0.0f, 0.211f}}, 40});
    site.lathe(Stuff::black, {{{0.0f, 0.208f}, {0.01f, 0.208f}, {0.016f, 0.225f}, {0.0f, 0.232f}}, 20});
    const glm::vec3 spout[] = {
        {-0.07f, 0.09f, 0.0f}, {-0.13f, 0.12f, 0.0f}, {-0.15f, 0.17f, 0.0f}, {-0.175f, 0.19f, 0.0f}};
    site.tube(Stuff::steel, {smooth(spout, 6), {0.014f}, 14});
    const glm::vec3 handle[] = {
        {-0.06f, 0.185f, 0.0f}, {-0.06f, 0.29f, 0.0f}, {0.09f, 0.29f, 0.0f}, {0.09f, 0.14f, 0.0f}};
    site.tube(Stuff::black, {rounded_path(handle, 0.05f, 8), {0.009f}, 12});
}

void add_toaster(const Site& site)
{
    site.box(Stuff::ceramic, {{-0.15f, 0.012f, -0.085f}, {0.15f, 0.19f, 0.085f}, 0.035f, 4},
             {0.75f, 0.28f, 0.20f});
    site.box(Stuff::black, {{-0.13f, 0.0f, -0.07f}, {0.13f, 0.02f, 0.07f}});
    for (const float z : {-0.032f, 0.032f})
        site.box(Stuff::black, {{-0.1f, 0.18f, z - 0.014f}, {0.1f, 0.1915f, z + 0.014f}, 0.001f});
    site.box(Stuff::chrome, {{0.148f, 0.11f, -0.02f}, {0.168f, 0.125f, 0.02f}, 0.005f, 2});
}

void add_coffee_machine(const Site& site)
{
    site.box(Stuff::steel, {{-0.13f, 0.0f, -0.16f}, {0.13f, 0.05f, 0.16f}, 0.01f, 2});
    site.box(Stuff::steel, {{-0.13f, 0.04f, -0.16f}, {0.13f, 0.33f, -0.02f}, 0.012f, 2});
    site.box(Stuff::black, {{-0.132f, 0.25f, -0.155f}, {0.132f, 0.37f, 0.13f}, 0.015f, 3});
    site.box(Stuff::black, {{-0.11f, 0.048f, 0.0f}, {0.11f, 0.053f, 0.14f}, 0.001f});
    site.at({0.0f, 0.21f, 0.07f})
        .lathe(Stuff::chrome,
               {{{0.0f, 0.0f}, {0.03f, 0.0f}, {0.036f, 0.008f}, {0.036f, 0.045f}, {0.0f, 0.045f}}, 24});
    site.tube(Stuff::black, {{{0.0f, 0.235f, 0.1f}, {0.0f, 0.225f, 0.23f}}, {0.013f, 0.011f}, 12});
    site.tube(Stuff::chrome,
              {{{0.11f, 0.27f, 0.1f}, {0.12f, 0.24f, 0.14f}, {0.12f, 0.10f, 0.16f}}, {0.005f}, 10});
    for (int i = 0; i < 3; ++i)
        site.at({-0.06f + 0.06f * static_cast<float>(i), 0.32f, 0.13f})
            .tipped(90.0f)
            .lathe(Stuff::chrome,
                   {{{0.0f, -0.003f}, {0.014f, -0.003f}, {0.014f, 0.004f}, {0.0f, 0.005f}}, 20});
    add_cup(site.at({0.0f, 0.053f, 0.07f}, 40.0f), plan::white);
}

void add_utensils(const Site& site)
{
    site.lathe(Stuff::ceramic,
               {{{0.0f, 0.0f},
                 {0.055f, 0.0f},
                 {0.06f, 0.006f},
                 {0.06f, 0.15f},
                 {0.055f, 0.15f},
                 {0.055f, 0.02f},
                 {0.0f, 0.02f}},
                32},
               {0.86f, 0.82f, 0.74f});
    const glm::vec3 woods[] = {plan::oak, plan::walnut, plan::pale_oak};
    for (int i = 0; i < 6; ++i) {
        const Site spoon =
            site.at({0.0f, 0.025f, 0.0f}, 60.0f * static_cast<float>(i) + 25.0f * site.chance())
                .tipped(10.0f);
        const float top = 0.26f + 0.06f * site.chance();
        const glm::vec3 tint = woods[i % 3];
        spoon.tube(Stuff::wood,
                   {{{0.0f, 0.0f, 0.0f}, {0.0f, top - 0.04f, 0.0f}, {0.0f, top, 0.0f}},
                    {0.0055f, 0.005f, 0.008f},
                    8},
                   tint);
        spoon.box(Stuff::wood, {{-0.024f, top - 0.005f, -0.004f}, {0.024f, top + 0.07f, 0.004f}, 0.0038f, 3},
                  tint);
    }
}

void add_knife_block(const Site& site)
{
    const Site block = site.tipped(-14.0f);
    block.box(Stuff::wood, {{-0.05f, 0.015f, -0.07f}, {0.05f, 0.22f, 0.07f}, 0.006f, 2}, plan::walnut);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 2; ++column) {
            const float x = -0.022f + 0.044f * static_cast<float>(column),
                        z = -0.045f + 0.045f * static_cast<float>(row);
            block.box(Stuff::black,
                      {{x - 0.009f, 0.215f, z - 0.012f}, {x + 0.009f, 0.30f, z + 0.012f}, 0.005f, 2});
            block.box(Stuff::steel,
                      {{x - 0.0095f, 0.219f, z - 0.0125f}, {x + 0.0095f, 0.226f, z + 0.0125f}, 0.001f});
        }
}

void add_books(const Site& site, int count)
{
    const glm::vec3 colors[] = {{0.55f, 0.16f, 0.12f}, {0.80f, 0.74f, 0.62f}, {0.16f, 0.27f, 0.36f},
                                {0.78f, 0.52f, 0.18f}, {0.30f, 0.40f, 0.28f}, {0.70f, 0.68f, 0.66f}};
    float x = 0.0f;
    for (int i = 0; i < count; ++i) {
        const float thick = 0.022f + 0.02f * site.chance(), high = 0.22f + 0.06f * site.chance();
        const float deep = 0.16f + 0.03f * site.chance();
        site.box(Stuff::cloth, {{x, 0.0f, 0.0f}, {x + thick - 0.001f, high, deep}, 0.003f}, colors[i % 6]);
        site.box(Stuff::cloth,
                 {{x + 0.003f, 0.003f, -0.001f}, {x + thick - 0.004f, high + 0.0005f, deep - 0.004f}},
                 plan::white);
        x += thick;
    }
}

} // namespace lambent::kitchen
