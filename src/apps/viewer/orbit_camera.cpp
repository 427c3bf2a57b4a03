#include "apps/viewer/orbit_camera.h"

#include "apps/viewer/parameters.h"
#include "base/text.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::viewer {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

bool is_empty(const scene::Bounds& bounds)
{
    return !(bounds.low.x <= bounds.high.x);
}

// Limits one move, so that amounts sent by a client keep all values finite.
double finite_clamp(double amount, double most)
{
    return std::isfinite(amount) ? std::clamp(amount, -most, most) : 0.0;
}

} // namespace

double radius_of(const scene::Bounds& bounds)
{
    if (is_empty(bounds))
        return 1.0;
    return std::max(0.5 * glm::length(glm::dvec3(bounds.high) - glm::dvec3(bounds.low)), 1e-6);
}

glm::dvec3 middle_of(const scene::Bounds& bounds)
{
    return is_empty(bounds) ? glm::dvec3(0.0) : 0.5 * (glm::dvec3(bounds.low) + glm::dvec3(bounds.high));
}

void OrbitCamera::orbit(double azimuth, double elevation)
{
    azimuth_ = std::remainder(azimuth_ + finite_clamp(azimuth, 360.0), 360.0);
    elevation_ = std::clamp(elevation_ + finite_clamp(elevation, 180.0), -90.0, 90.0);
}

void OrbitCamera::pan(const World& world, double right, double up, double vertical_fov)
{
    fix(world);
    const double azimuth = azimuth_ * degree, elevation = elevation_ * degree;
    const glm::dvec3 across(std::cos(azimuth), 0.0, -std::sin(azimuth));
    const glm::dvec3 back(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                          std::cos(elevation) * std::cos(azimuth));
    const double height = 2.0 * std::tan(0.5 * vertical_fov * degree) * *distance_;
    look_at(world, *target_ - height * (finite_clamp(right, 10.0) * across +
                                        finite_clamp(up, 10.0) * glm::cross(back, across)));
}

void OrbitCamera::dolly(const World& world, double amount)
{
    fix(world);
    const double radius = radius_of(world.bounds);
    distance_ = std::clamp(*distance_ * std::exp(finite_clamp(amount, 10.0)), EyeLimits::nearest * radius,
                           EyeLimits::farthest * radius);
}

void OrbitCamera::look_at(const World& world, const glm::dvec3& point)
{
    fix(world);
    const glm::dvec3 middle = middle_of(world.bounds) + world.origin;
    const double most = EyeLimits::target * radius_of(world.bounds);
    target_ = glm::clamp(point, middle - most, middle + most);
}

std::vector<std::string> OrbitCamera::options() const
{
    const std::string angles = text(number_word(azimuth_), ",", number_word(elevation_));
    if (!distance_)
        return {"--camera", angles};
    std::vector<std::string> options = {"--camera", text(angles, ",", number_word(*distance_))};
    if (target_)
        options.insert(options.end(), {"--target", text(place_word(target_->x, *distance_), ",",
                                                        place_word(target_->y, *distance_), ",",
                                                        place_word(target_->z, *distance_))});
    return options;
}

glm::dvec3 OrbitCamera::target(const World& world) const
{
    return target_.value_or(middle_of(world.bounds) + world.origin);
}

void OrbitCamera::fix(const World& world)
{
    distance_ = distance(world);
    target_ = target(world);
}

} // namespace lambent::viewer
