#include "reference/light_arrival.h"

#include "equations/in_double.h"

#include <glm/geometric.hpp>

#include <limits>
#include <numbers>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function" // only part of the shared code is used here

namespace lambent::in_double {
namespace {

#include "shading/lobes/arrival.glsl"

} // namespace
} // namespace lambent::in_double

#pragma GCC diagnostic pop

namespace lambent::reference {
namespace {

in_double::vec3 text(const glm::vec3& v)
{
    const glm::dvec3 d(v);
    return {d.x, d.y, d.z};
}

glm::dvec3 vec(const in_double::vec3& v)
{
    return {v.x, v.y, v.z};
}

} // namespace

LightArrival arrival_of(const scene::Light& light, const glm::dvec3& point)
{
    if (light.kind == scene::LightKind::directional)
        return {-glm::normalize(glm::dvec3(light.direction)), glm::dvec3(light.intensity),
                std::numeric_limits<double>::infinity()};
    const bool spot = light.kind == scene::LightKind::spot;
    const in_double::LocalLight local = {text(light.position),
                                         text(light.intensity),
                                         text(light.direction),
                                         1.0 / static_cast<double>(light.range),
                                         spot ? std::cos(static_cast<double>(light.inner_cone)) : -2.0,
                                         spot ? std::cos(static_cast<double>(light.outer_cone)) : -3.0};
    const in_double::Arrival a = in_double::arrival_from(local, {point.x, point.y, point.z});
    return {vec(a.direction), vec(a.illuminance), glm::length(glm::dvec3(light.position) - point)};
}

glm::dvec3 blurred(const glm::dvec3& direction, double roughness, SampleSequence& sampler)
{
    // The angle is Rayleigh distributed. [Box and Muller 1958]
    const double deviation = roughness * roughness;
    const double angle = deviation * std::sqrt(-2.0 * std::log(1.0 - sampler.random()));
    const double turn = 2.0 * std::numbers::pi * sampler.random();
    const double sine = std::sin(angle);
    return vec(in_double::orthonormal_frame({direction.x, direction.y, direction.z}) *
               in_double::vec3(sine * std::cos(turn), sine * std::sin(turn), std::cos(angle)));
}

} // namespace lambent::reference
