// What one viewer wants to see, and the command that draws it.
#pragma once

#include "apps/options/arguments.h"
#include "apps/viewer/orbit_camera.h"
#include "apps/viewer/parameters.h"

#include <string>
#include <vector>

namespace lambent::viewer {

struct ViewRequest {
    /// Each option by itself, without the camera and the moment: also what says nothing of this scene and model.
    cli::RenderArguments asked;
    OrbitCamera eye;
    double moment = 0.0; ///< of the animation, seconds from its start
};

/// At most this many lights, and this many pixels in a picture.
constexpr std::size_t most_lights = 16;
constexpr int most_pixels = 2560 * 1600;

/// A scene from where it is looked at first, with every option at its default.
ViewRequest plain_wish(const std::string& scene, const std::string& environment);

/// What a command line asks to see at first, without its animation and the camera of the scene. Throws Error(usage) where a value is none that its control can be set to.
ViewRequest first_wish(const cli::StartArguments& start);

/// Where a scene is looked at from at first.
OrbitCamera first_eye(const std::string& scene);

/// The view of a camera of the scene, upright. `request` gets its field of view; an orthographic one becomes one that sees as
/// much at the scene's middle. Throws Error(usage) where there is no camera of this name.
void look_through(ViewRequest& request, const scene::Scene& scene, const std::string& camera);

/// Checks the words and takes them. Throws Error(usage) with one line.
void set_lights(ViewRequest& request, const std::vector<std::string>& lights);

/// Sides are cut to what may be drawn: from 16 pixels to most_pixels in all, in the proportion asked for.
void set_size(ViewRequest& request, double width, double height);

/// An animation of the scene by its number, at its start; below 0: none. Throws Error(usage) where there is none such.
void animate(ViewRequest& request, const std::vector<scene::AnimationInfo>& animations, double number);

/// The number of the animation that is wished; -1: none, or it is not there.
int animation_of(const ViewRequest& request, const std::vector<scene::AnimationInfo>& animations);

/// The environment's rotation grows by so many degrees, and stays from -180 to 180.
void turn_environment(ViewRequest& request, double degrees);

/// "render", the scene and the options, without an output.
std::vector<std::string> words_of(const ViewRequest& request);

/// The command that writes the picture, for a POSIX shell.
std::string command_of(const ViewRequest& request, const std::string& output);

/// What `lambent` takes from these words: a picture drawn from this is the command's.
cli::RenderArguments arguments_of(const ViewRequest& request);

} // namespace lambent::viewer
