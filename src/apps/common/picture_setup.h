// Scene, lights and camera of the commands that make pictures.
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

/// Loads the built-in scene or the file, at the animation time asked for. The file may refer to others in any folder;
/// they are added to `inputs`, if given. Throws as scene::load_gltf and moment_asked.
scene::Scene load_scene(const RenderArguments& arguments, Warnings& warnings, InputFiles* inputs = nullptr);

/// The files that the command line itself names: the scene's and the environment's.
InputFiles inputs_named(const RenderArguments& arguments);

/// The animation and the time in it that are asked for, if any. Throws Error(usage) if the animation is not one of
/// `animations`, with their names.
std::optional<scene::Moment> moment_asked(const RenderArguments& arguments,
                                          std::span<const scene::AnimationInfo> animations);

/// The camera of the orbit asked for, or of the default view, for a scene with these bounds; ignores the camera node.
/// Like the bounds, it is relative to the scene's origin.
view::Camera orbit_asked(const RenderArguments& arguments, const scene::Bounds& bounds,
                         const glm::dvec3& origin);

/// The lights asked for, relative to the scene's origin.
std::vector<scene::Light> lights_asked(const RenderArguments& arguments, const glm::dvec3& origin);

/// The default view of a scene. Its distance is 0: the camera frames the scene.
view::Orbit default_orbit(const std::string& scene);

/// The camera node, orbit or default view asked for. Throws Error(usage) for a camera node that does not exist.
view::Camera choose_camera(const RenderArguments& arguments, const scene::Scene& scene);

} // namespace lambent::cli
