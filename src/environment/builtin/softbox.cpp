#include "environment/builtin/softbox.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <cmath>

namespace lambent::environment {
namespace {

// Radiance of the cloth and of the box behind it.
constexpr float frame_radiance = 0.015f;

// Signed distance from a rounded rectangle around the origin.
float outside(const glm::vec2& p, const glm::vec2& half_size, float corner)
{
    const glm::vec2 beyond = glm::abs(p) - half_size + corner;
    return glm::length(glm::max(beyond, 0.0f)) + std::fmin(std::fmax(beyond.x, beyond.y), 0.0f) - corner;
}

float coverage(float outside, float texel)
{
    return glm::smoothstep(-0.5f, 0.5f, -0.67f * outside / texel);
}

} // namespace

PlacedSoftbox::PlacedSoftbox(const Softbox& box)
    : box_(box), towards_(glm::normalize(box.centre)), distance_(glm::length(box.centre))
{
    // Right and up as seen from the origin, upright unless the softbox hangs straight above.
    const glm::vec3 vertical =
        std::fabs(towards_.y) < 0.99f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
    const glm::vec3 right = glm::normalize(glm::cross(towards_, vertical));
    const glm::vec3 up = glm::cross(right, towards_);
    right_ = std::cos(box.roll) * right + std::sin(box.roll) * up;
    up_ = glm::cross(right_, towards_);
    const float radius = glm::length(box.half_size + 2.0f * box.frame) + 0.1f * distance_;
    reach_ = distance_ / std::sqrt(distance_ * distance_ + radius * radius);
}

glm::vec3 PlacedSoftbox::over(const glm::vec3& behind, const glm::vec3& direction, float texel) const
{
    const float cosine = glm::dot(direction, towards_);
    if (cosine < reach_)
        return behind;
    const glm::vec3 p = (distance_ / cosine) * direction;
    const glm::vec2 position(glm::dot(p, right_), glm::dot(p, up_));
    const float width = texel * distance_ / (cosine * cosine);
    const float from_edge = outside(position, box_.half_size, box_.corner);
    const float shining = coverage(from_edge, width), covered = coverage(from_edge - box_.frame, width);
    const glm::vec2 share = position / box_.half_size;
    const float falloff = box_.edge + (1.0f - box_.edge) * std::exp(-glm::dot(share, share));
    return (1.0f - covered) * behind + (covered - shining) * frame_radiance +
           shining * falloff * box_.radiance;
}

} // namespace lambent::environment
