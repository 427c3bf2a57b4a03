#include "scene/material.h"

#include <cstddef>

namespace lambent::scene {
namespace {

// Numbers of rows of the lists, and whether the rows are numbered consecutively.
struct Rows {
    int numbers = 0, textures = 0, layers = 0;
    bool in_order = true;

    constexpr void add_parameter(int number, int count)
    {
        in_order = in_order && number == numbers;
        numbers += count;
    }
    constexpr void add_texture(int number) { in_order = in_order && number == textures++; }
    constexpr void add_layer(int number) { in_order = in_order && number == ++layers; }
};

constexpr Rows count_rows()
{
    Rows rows;
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) rows.add_parameter(number, 4);
#define COLOR(name, number, value, object, key, texture) rows.add_parameter(number, 3);
#define SCALAR(name, number, value, object, key, texture, channel) rows.add_parameter(number, 1);
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) rows.add_parameter(number, 1);
#define STRENGTH(name, factor, number, value, object, key, texture, channel) rows.add_parameter(number, 1);
#include "shading/material/parameters.h"
#define TEXTURE(name, number, transfer, object, key) rows.add_texture(number);
#define NORMAL_TEXTURE(name, number, object, key) rows.add_texture(number);
#include "shading/material/textures.h"
#define LAYER(name, number, normal) rows.add_layer(number);
#include "shading/lobes/layers.h"
    return rows;
}

static_assert(count_rows().in_order, "numbers follow each other");

} // namespace

bool has_layers(const Material& material)
{
    return false
#define LAYER(name, number, normal) || material.name > 0.0f
#include "shading/lobes/layers.h"
        ;
}

std::array<float, parameter_numbers> factors_of(const Material& material)
{
    std::array<float, parameter_numbers> factors{};
    const auto set = [&](std::size_t number, float value) { factors[number] = value; };
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture)                                    \
    for (int i = 0; i < 4; ++i)                                                                              \
        set(number + static_cast<std::size_t>(i), material.name[i]);
#define COLOR(name, number, value, object, key, texture)                                                     \
    for (int i = 0; i < 3; ++i)                                                                              \
        set(number + static_cast<std::size_t>(i), material.name[i]);
#define SCALAR(name, number, value, object, key, texture, channel) set(number, material.name);
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) set(number, material.factor);
#define STRENGTH(name, factor, number, value, object, key, texture, channel) set(number, material.factor);
#include "shading/material/parameters.h"
    return factors;
}

std::array<float, texture_count> normal_scales_of(const Material& material)
{
    std::array<float, texture_count> scales{};
    scales.fill(1.0f);
#define TEXTURE(name, number, transfer, object, key)
#define NORMAL_TEXTURE(name, number, object, key) scales[texture_##name] = material.name##_scale;
#include "shading/material/textures.h"
    return scales;
}

} // namespace lambent::scene
