// What the commands that make pictures have in common: the scene and the camera asked for.
#pragma once

#include "apps/options/arguments.h"
#include "apps/common/input_files.h"
#include "base/error.h"
#include "scene/gltf/gltf.h"
#include "scene/scene.h"

#include <optional>
#include <span>
#include <vector>

namespace lambent::cli {

/// The built-in scene or the file, with what it names anywhere, at the moment asked for. Throws as scene::load_gltf and moment_asked. The files that
/// the scene's file names beside it are added to `inputs`, if given.
scene::Scene load_scene(const RenderArguments& arguments, Warnings& warnings, InputFiles* inputs = nullptr);

/// What the command line itself names: the scene's file and the environment's.
InputFiles inputs_named(const RenderArguments& arguments);

/// The moment asked for of a file with these animations; none: it stands still. Throws Error(usage), naming them, where
/// the one asked for is not there.
std::optional<scene::Moment> moment_asked(const RenderArguments& arguments,
                                          std::span<const scene::AnimationInfo> animations);

/// The orbit or default view asked for of a scene in this box, whatever the camera node. As the box is, it is relative to the
/// scene's origin.
view::Camera orbit_asked(const RenderArguments& arguments, const scene::Bounds& bounds,
                         const glm::dvec3& origin);

/// The lights asked for, relative to the scene's origin.
std::vector<scene::Light> lights_asked(const RenderArguments& arguments, const glm::dvec3& origin);

/// From where a scene is looked at when nothing is said: the distance is 0.
view::Orbit default_orbit(const std::string& scene);

/// The camera node, orbit or default view asked for. Throws Error(usage) for a camera node that is not there.
view::Camera choose_camera(const RenderArguments& arguments, const scene::Scene& scene);

} // namespace lambent::cli
