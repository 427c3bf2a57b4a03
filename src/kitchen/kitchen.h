// A modern kitchen, all made by code: the place whose light is the product's usual environment.
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

namespace lambent::kitchen {

/// The room: 5.7 m along X, 5.6 m along Z, 2.7 m high, its floor at y = 0. Windows towards +X (over the sink), a patio
/// door towards +Z, the island towards -Z, dressers towards -X. The openings have no glass: what is seen through
/// them is the environment. Emissive surfaces are in the units of the environment `sky`
/// (environment::sky_nits_per_unit). The same at every call; takes a few ten milliseconds.
scene::Scene make_kitchen();

/// Eye of the panorama, metres: between island and patio door. Nothing is within 0.3 m of it.
glm::vec3 kitchen_viewpoint();

/// Where the sun has to stand for patches of sun on floor, counter and island: radians, as
/// environment::BuiltinOptions has them.
constexpr float sun_azimuth = 1.05f;
constexpr float sun_elevation = 0.46f;

} // namespace lambent::kitchen
