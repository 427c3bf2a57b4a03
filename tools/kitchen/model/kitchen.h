// A modern kitchen, modelled by code: the room of the default environment.
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

namespace lambent::kitchen {

/// The room: 5.7 m along X, 5.6 m along Z, 2.7 m high, its floor at y = 0. Windows towards +X (over the sink), a patio
/// door towards +Z, the island towards -Z, dressers towards -X. The openings have no glass: rays leave
/// through them into the environment. Emissive surfaces are in the units of the environment `sky`
/// (environment::sky_nits_per_unit). Every call returns the same; takes some tens of
/// milliseconds.
scene::Scene make_kitchen();

/// Viewpoint of the panorama, metres: between island and patio door. No surface is within 0.3 m of it.
glm::vec3 kitchen_viewpoint();

/// Position of the sun for which there are patches of sunlight on floor, counter and island: radians, as in
/// environment::BuiltinOptions.
constexpr float sun_azimuth = 1.05f;
constexpr float sun_elevation = 0.46f;
constexpr float sky_turbidity = 2.2f;

/// Factor from radiance in the units of `sky` to that of the panorama, for which objects in the room are lit about as
/// brightly as in the environment `studio`: radiance 1 of the panorama is environment::sky_nits_per_unit / exposure in
/// cd/m^2.
constexpr float exposure = 9.0f;

} // namespace lambent::kitchen
