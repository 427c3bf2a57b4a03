#include "draw/textures/typical_alpha.h"

#include "equations/in_double.h"
#include "image/packed_texel.h"

#include <algorithm>
#include <cstring>

namespace lambent::draw {
namespace {

// Texel (x, y) of a level, linear.
glm::vec4 texel_of(const PackedTexture& t, int level, int x, int y)
{
    const std::size_t pitch = static_cast<std::size_t>(t.width[level]) + 2;
    const std::size_t at = static_cast<std::size_t>(t.start[level]) +
                           static_cast<std::size_t>(y + 1) * pitch + static_cast<std::size_t>(x + 1);
    glm::vec4 value(1.0f);
    for (int channel = 0; channel < 4; ++channel) {
        const std::uint8_t* const bytes = t.bytes.data() + (t.half_floats ? 8 : 4) * at;
        if (t.half_floats) {
            std::uint16_t half = 0;
            std::memcpy(&half, bytes + 2 * channel, 2);
            value[channel] = image::from_half(half);
        } else {
            value[channel] = (channel < 3 ? t.light : t.alpha)[bytes[channel]];
        }
    }
    return value;
}

float squared(float roughness)
{
    return roughness * roughness;
}

} // namespace

glm::vec4 mean_texel(const PackedTexture* texture)
{
    if (!texture)
        return glm::vec4(1.0f);
    constexpr int most = 64;
    const int level = texture->levels - 1, width = texture->width[level], height = texture->height[level];
    const int columns = std::min(width, most), rows = std::min(height, most);
    glm::dvec4 sum(0.0);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            sum +=
                glm::dvec4(texel_of(*texture, level, static_cast<int>(std::int64_t{column} * width / columns),
                                    static_cast<int>(std::int64_t{row} * height / rows)));
    return glm::vec4(sum / static_cast<double>(rows * columns));
}

TypicalAlpha::TypicalAlpha(const scene::Material& material, const MaterialTextures& textures)
{
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture)
#define COLOR(name, number, value, object, key, texture)
#define SCALAR(name, number, value, object, key, texture, channel)
#define STRENGTH(name, factor, number, value, object, key, texture, channel)
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel)                                \
    const float name = squared(                                                                              \
        material.factor * mean_texel(textures[static_cast<std::size_t>(scene::texture_##texture)]).channel);
#include "shading/material/parameters.h"
    ggx = alpha;
#define LAYER(name, number, texture)                                                                         \
    if (material.name > 0.0f)                                                                                \
        ggx = std::min(ggx, name##_alpha);
#include "shading/lobes/layers.h"
    phong = alpha;
    if (material.phong.exponent)
        phong = static_cast<float>(in_double::phong_alpha(static_cast<double>(*material.phong.exponent)));
}

float TypicalAlpha::in(const Settings& settings) const
{
    if (settings.model == Model::phong)
        return phong;
    return settings.roughness_override ? squared(*settings.roughness_override) : ggx;
}

} // namespace lambent::draw
