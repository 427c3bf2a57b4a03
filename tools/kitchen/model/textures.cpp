#include "kitchen/model/textures.h"

#include "kitchen/model/noise.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::kitchen {
namespace {

constexpr float turn = 2.0f * std::numbers::pi_v<float>;

std::uint8_t code(float linear)
{
    const double l = std::clamp(static_cast<double>(linear), 0.0, 1.0);
    const double encoded = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

// A square image of a function from position to linear colour.
template <class Color>
image::CodeImage painted(int size, Color&& color)
{
    image::CodeImage image{size, size, 4, 8, {}};
    image.bytes.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::vec3 c = color((static_cast<float>(x) + 0.5f) / static_cast<float>(size),
                                      (static_cast<float>(y) + 0.5f) / static_cast<float>(size));
            image.bytes.insert(image.bytes.end(), {code(c.x), code(c.y), code(c.z), 255});
        }
    return image;
}

glm::vec3 wood(float u, float v)
{
    // Growth rings cut lengthwise: bands across the board that drift slowly along it.
    const float wander = 1.6f * fractal_noise(u, v, {3, 2, 11}, 3);
    const float ring = 0.5f + 0.5f * std::sin(turn * (9.0f * u + wander));
    const float late = ring * ring * ring; // late wood is a narrow dark line
    const float fibre = fractal_noise(u, v, {128, 6, 23}, 2);
    const float pore = std::max(value_noise(256.0f * u, 16.0f * v, {256, 16, 37}) - 0.55f, 0.0f);
    const float cloud = fractal_noise(u, v, {2, 3, 41}, 2);
    const float dark = glm::clamp(0.42f * late + 0.30f * fibre + 0.25f * cloud + 0.9f * pore, -0.3f, 1.0f);
    return glm::mix(glm::vec3(0.80f, 0.80f, 0.80f), glm::vec3(0.50f, 0.42f, 0.35f), dark);
}

glm::vec3 marble(float u, float v)
{
    const float bend = fractal_noise(u, v, {4, 4, 51}, 4);
    const float coarse = std::fabs(fractal_noise(u + 0.18f * bend, v + 0.12f * bend, {2, 3, 61}, 3));
    const float fine = std::fabs(fractal_noise(u - 0.1f * bend, v + 0.1f * bend, {6, 5, 71}, 3));
    const float vein = 0.75f * std::exp(-22.0f * coarse) + 0.3f * std::exp(-30.0f * fine);
    const float cloud = 0.05f * bend;
    return glm::mix(glm::vec3(0.80f + cloud), glm::vec3(0.36f, 0.37f, 0.39f), std::min(vein, 1.0f));
}

glm::vec3 rug(float u, float v)
{
    const glm::vec3 wool(0.66f, 0.60f, 0.50f), blue(0.10f, 0.16f, 0.24f), rust(0.42f, 0.15f, 0.08f);
    const float edge = std::min({u, 1.0f - u, v, 1.0f - v});
    glm::vec3 color = wool;
    if (edge > 0.04f && edge < 0.055f)
        color = rust;
    else if (edge > 0.07f && edge < 0.1f)
        color = blue;
    else if (edge >= 0.12f) {
        // Nested lozenges.
        const float s = 4.0f * u, t = 6.0f * v;
        const float away = std::fabs(s - std::floor(s) - 0.5f) + std::fabs(t - std::floor(t) - 0.5f);
        color = away < 0.14f ? rust : away > 0.26f && away < 0.36f ? blue : wool;
    }
    const float thread = 0.5f + 0.5f * std::sin(turn * 128.0f * v);
    const float worn = fractal_noise(u, v, {6, 6, 83}, 4);
    return color * (0.9f - 0.12f * thread + 0.12f * worn);
}

} // namespace

image::CodeImage wood_texture()
{
    return painted(384, wood);
}

image::CodeImage marble_texture()
{
    return painted(384, marble);
}

image::CodeImage rug_texture()
{
    return painted(256, rug);
}

} // namespace lambent::kitchen
