// The view that a viewer asks for, and the command that draws it.
#pragma once

#include "apps/options/arguments.h"
#include "apps/viewer/orbit_camera.h"
#include "apps/viewer/parameters.h"

#include <string>
#include <vector>

namespace lambent::viewer {

struct ViewRequest {
    /// All options except the camera and the moment, also those without effect on this scene and model.
    cli::RenderArguments asked;
    OrbitCamera eye;
    double moment = 0.0; ///< time of the animation, seconds from its start
};

/// Limits on lights, and on the pixels of a picture.
constexpr std::size_t most_lights = 16;
constexpr int most_pixels = 2560 * 1600;

/// A scene seen from its default camera, with every option at its default.
ViewRequest default_request(const std::string& scene, const std::string& environment);

/// The request of a command line, without its animation and its --camera-node, which need the loaded scene. Throws
/// Error(usage) where a control cannot be set to a value.
ViewRequest starting_request(const cli::StartArguments& start);

/// The default camera of a scene.
OrbitCamera default_camera(const std::string& scene);

/// Takes the view of a camera of the scene, with the up direction vertical, and its field of view. An orthographic
/// camera is replaced by a perspective one that shows the same height at the middle of the scene. Throws Error(usage)
/// if there is no camera of this name.
void look_through(ViewRequest& request, const scene::Scene& scene, const std::string& camera);

/// Sets the lights from words of --light. Throws Error(usage) with one line for invalid or too many words.
void set_lights(ViewRequest& request, const std::vector<std::string>& lights);

/// Sets the size: sides from 16 to 16384, then scaled down in proportion to at most most_pixels in all.
void set_size(ViewRequest& request, double width, double height);

/// Chooses an animation by its number, at its start; below 0: none. Throws Error(usage) if there is no such animation.
void animate(ViewRequest& request, const std::vector<scene::AnimationInfo>& animations, double number);

/// The number of the requested animation; -1: none is requested, or it does not exist.
int animation_of(const ViewRequest& request, const std::vector<scene::AnimationInfo>& animations);

/// Adds to the rotation of the environment, in degrees; the sum is wrapped to -180 to 180.
void turn_environment(ViewRequest& request, double degrees);

/// The words of the command: "render", the scene and the options, without an output.
std::vector<std::string> words_of(const ViewRequest& request);

/// The command that writes the picture, quoted for a POSIX shell.
std::string command_of(const ViewRequest& request, const std::string& output);

/// The arguments that `lambent` parses from words_of(): a picture drawn with them is that of the command.
cli::RenderArguments arguments_of(const ViewRequest& request);

} // namespace lambent::viewer
