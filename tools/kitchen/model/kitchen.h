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
constexpr float sky_turbidity = 2.2f;

/// Factor from light in the units of `sky` to the panorama, so that things in the room are lit about as brightly as in the
/// environment `studio`: radiance 1 of the panorama is environment::sky_nits_per_unit / exposure in cd/m^2.
constexpr float exposure = 9.0f;

} // namespace lambent::kitchen
