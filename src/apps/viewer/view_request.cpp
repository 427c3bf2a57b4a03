#include "apps/viewer/view_request.h"

#include "apps/common/picture_setup.h"
#include "apps/options/rules.h"
#include "apps/options/values.h"
#include "base/error.h"
#include "base/shell.h"
#include "base/text.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

namespace lambent::viewer {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

// Keeps a file name that begins with a dash from being read as an option.
std::string as_file(const std::string& name)
{
    return name.starts_with('-') ? text("./", name) : name;
}

// The camera of the word of --camera and the point of --target.
OrbitCamera eye_of(const std::string& word, const std::optional<glm::dvec3>& target)
{
    const std::vector<double> numbers = cli::parse_list(word, {2, 3}, "--camera");
    if (numbers.size() == 2)
        return {numbers[0], numbers[1]};
    return {numbers[0], numbers[1], numbers[2], target};
}

// Sets an option, within the range of its control and rounded as by it if it has one.
void set_option(cli::RenderArguments& asked, const Parameter& row, const std::string& word)
{
    const cli::Option& option = row.option;
    row.value.set(asked, option, word);
    if (!option.control.label.empty())
        set_value(asked, option.name, row.value.get(asked, option));
}

// The options of the command that follow those of the camera, in order.
std::vector<cli::OptionWord> words_behind_camera(const cli::RenderArguments& arguments)
{
    std::vector<cli::OptionWord> words = cli::words_of(arguments, cli::command::render);
    std::erase_if(words, [](const cli::OptionWord& word) { return word.option->place == 0; });
    std::ranges::stable_sort(words, {}, [](const cli::OptionWord& word) { return word.option->place; });
    return words;
}

// The options with the camera, without those that have no effect on this scene and model.
cli::RenderArguments effective(const ViewRequest& request)
{
    cli::RenderArguments arguments = request.asked;
    arguments.scene = as_file(arguments.scene);
    arguments.environment = as_file(arguments.environment);
    if (!arguments.animation.empty())
        arguments.moment = std::stod(number_word(request.moment));
    cli::for_each_row<cli::RenderArguments>(cli::command::render, [&](const Parameter& row) {
        if (!cli::applies(row.option.needs, arguments))
            row.value.set(arguments, row.option, "");
    });
    if (cli::draws_as_report(arguments))
        arguments.bounces = cli::RenderArguments().bounces; // has no effect
    const std::vector<std::string> eye = request.eye.options();
    arguments.orbit = cli::parse_orbit(eye.at(1), eye.at(0));
    if (eye.size() > 2)
        arguments.target = cli::parse_point(eye.at(3), eye.at(2));
    return arguments;
}

} // namespace

OrbitCamera default_camera(const std::string& scene)
{
    const view::Orbit orbit = cli::default_orbit(scene);
    return {static_cast<double>(orbit.azimuth) * degrees, static_cast<double>(orbit.elevation) * degrees};
}

ViewRequest default_request(const std::string& scene, const std::string& environment)
{
    ViewRequest request{{}, default_camera(scene)};
    request.asked.scene = scene;
    request.asked.environment = environment;
    return request;
}

ViewRequest starting_request(const cli::StartArguments& start)
{
    const cli::RenderArguments& picture = start.picture;
    ViewRequest request = default_request(picture.scene, picture.environment);
    if (picture.light_words.size() > most_lights)
        throw Error(Failure::usage, text("--light: ", picture.light_words.size(),
                                         " lights, but a viewer has at most ", most_lights));
    set_size(request, picture.settings.width, picture.settings.height);
    if (start.given("camera"))
        request.eye = eye_of(start.given.words("camera").back(), picture.target);
    cli::for_each_row<cli::RenderArguments>(cli::command::render, [&](const Parameter& row) {
        // Options of animations are left to load_first, as the scene is not loaded yet.
        if (row.option.place > 0 && row.option.needs != cli::Needs::file)
            for (const std::string& word : start.given.words(row.option.name))
                set_option(request.asked, row, word);
    });
    return request;
}

void look_through(ViewRequest& request, const scene::Scene& scene, const std::string& camera)
{
    cli::RenderArguments asked;
    asked.scene = request.asked.scene;
    asked.camera_node = camera;
    const view::Camera found = cli::choose_camera(asked, scene);
    const glm::dvec3 back(found.back), position(found.position);
    const scene::Bounds bounds = scene::framed_bounds(scene);
    const double far_enough = 1e-3 * radius_of(bounds);
    double distance = std::max(glm::dot(position - middle_of(bounds), back), far_enough);
    // A picture narrower than the camera's aspect ratio shows the camera's whole width.
    const double wider = std::max(static_cast<double>(found.aspect) * request.asked.settings.height /
                                      request.asked.settings.width,
                                  1.0);
    if (found.vertical_fov > 0.0f) {
        const double half = wider * std::tan(0.5 * static_cast<double>(found.vertical_fov));
        const double fov = 2.0 * std::atan(half) * degrees;
        set_nearest(request.asked, "fov", fov);
    } else {
        const double fov = number_in(request.asked, "fov") / degrees;
        distance = 0.5 * wider * static_cast<double>(found.vertical_size) / std::tan(0.5 * fov);
    }
    request.eye = {std::atan2(back.x, back.z) * degrees, std::asin(std::clamp(back.y, -1.0, 1.0)) * degrees,
                   distance, scene.origin + position - distance * back};
}

void set_lights(ViewRequest& request, const std::vector<std::string>& lights)
{
    if (lights.size() > most_lights)
        throw Error(Failure::usage,
                    text("lights: ", lights.size(), " lights, but at most ", most_lights, " are possible"));
    for (const std::string& light : lights)
        cli::parse_light(light, "light");
    cli::Given given;
    for (const std::string& light : lights)
        given.add("light", light);
    request.asked.settings.lights.clear();
    request.asked.light_places.clear();
    request.asked.light_words.clear();
    cli::take(given, cli::command::render, request.asked);
}

void animate(ViewRequest& request, const std::vector<scene::AnimationInfo>& animations, double number)
{
    if (!(number < static_cast<double>(animations.size())) || (number >= 0.0 && number != std::floor(number)))
        throw Error(Failure::usage, text("there is no animation ", number));
    request.moment = 0.0;
    request.asked.animation.clear();
    if (number < 0.0)
        return;
    // By its name, unless that has control characters or also is the name or number of another animation.
    const auto index = static_cast<std::size_t>(number);
    const std::string& name = animations[index].name;
    if (std::none_of(name.begin(), name.end(),
                     [](char c) { return std::iscntrl(static_cast<unsigned char>(c)); }))
        request.asked.animation = name;
    if (animation_of(request, animations) != static_cast<int>(index))
        request.asked.animation = text(index);
}

int animation_of(const ViewRequest& request, const std::vector<scene::AnimationInfo>& animations)
{
    cli::RenderArguments arguments;
    arguments.animation = request.asked.animation;
    try {
        const std::optional<scene::Moment> moment = cli::moment_asked(arguments, animations);
        return moment ? moment->animation : -1;
    } catch (const Error&) {
        return -1;
    }
}

void turn_environment(ViewRequest& request, double degrees)
{
    const double before = number_in(request.asked, "env-rotation");
    const double turned = std::remainder(before + std::fmod(degrees, 360.0), 360.0);
    set_value(request.asked, "env-rotation", number_word(turned));
}

void set_size(ViewRequest& request, double width, double height)
{
    const auto side = [](double length) {
        return std::isfinite(length) ? std::clamp(length, 16.0, 16384.0) : 16.0;
    };
    const double w = side(width), h = side(height);
    const double shrink = std::min(1.0, std::sqrt(most_pixels / (w * h)));
    int &across = request.asked.settings.width, &down = request.asked.settings.height;
    across = std::max(16, static_cast<int>(w * shrink));
    down = std::max(16, static_cast<int>(h * shrink));
    while (static_cast<double>(across) * down > most_pixels)
        --(across > down ? across : down);
}

std::vector<std::string> words_of(const ViewRequest& request)
{
    const cli::RenderArguments arguments = effective(request);
    std::vector<std::string> words = {"render", arguments.scene};
    const auto add = [&](const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
    };
    if (arguments.environment != cli::RenderArguments().environment)
        add({"--env", arguments.environment});
    add({"--size", cli::size_word({arguments.settings.width, arguments.settings.height})});
    add(request.eye.options());
    for (const cli::OptionWord& word : words_behind_camera(arguments))
        cli::append(words, word);
    return words;
}

std::string command_of(const ViewRequest& request, const std::string& output)
{
    std::string command = "lambent";
    for (const std::string& word : words_of(request))
        command += text(" ", shell_quoted(word));
    return text(command, " -o ", shell_quoted(output));
}

cli::RenderArguments arguments_of(const ViewRequest& request)
{
    cli::RenderArguments arguments = effective(request);
    cli::derive(arguments);
    return arguments;
}

} // namespace lambent::viewer
