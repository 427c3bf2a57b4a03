#include "compare/flip_color.h"

#include <algorithm>

namespace lambent::compare {
namespace {

constexpr float q_c = 0.7f, p_c = 0.4f, p_t = 0.95f;

// The CIE's cube root, linear near 0.
float lab_curve(float t)
{
    constexpr float delta = 6.0f / 29.0f;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
}

float largest_power()
{
    const Color green = hunt_lab(transformed(rgb_to_xyz, {0.0f, 1.0f, 0.0f}));
    const Color blue = hunt_lab(transformed(rgb_to_xyz, {0.0f, 0.0f, 1.0f}));
    return std::pow(hyab(green, blue), q_c);
}

} // namespace

Color hunt_lab(const Color& xyz)
{
    const float x = lab_curve(xyz.x), y = lab_curve(xyz.y), z = lab_curve(xyz.z);
    const float lightness = 116.0f * y - 16.0f;
    const float hunt = 0.01f * lightness;
    return {lightness, hunt * 500.0f * (x - y), hunt * 200.0f * (y - z)};
}

float color_error(float hyab_distance)
{
    static const float largest = largest_power();
    const float bend = p_c * largest;
    const float power = std::pow(hyab_distance, q_c);
    if (power < bend)
        return p_t / bend * power;
    return std::min(p_t + (power - bend) / (largest - bend) * (1.0f - p_t), 1.0f);
}

} // namespace lambent::compare
