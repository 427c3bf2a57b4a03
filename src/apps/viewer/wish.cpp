#include "apps/viewer/wish.h"

#include "apps/common/picture_setup.h"
#include "apps/options/values.h"
#include "base/error.h"
#include "base/shell.h"
#include "base/text.h"
#include "scene/builtin/builtin.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <variant>

namespace lambent::viewer {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

// A file whose name looks like an option is none.
std::string as_file(const std::string& name)
{
    return name.starts_with('-') ? text("./", name) : name;
}

// The word of --camera, with the point that --target names.
Eye eye_of(const std::string& word, const std::optional<glm::dvec3>& target)
{
    const std::vector<double> numbers = cli::parse_list(word, {2, 3}, "--camera");
    if (numbers.size() == 2)
        return {numbers[0], numbers[1]};
    return {numbers[0], numbers[1], numbers[2], target};
}

void set_option(Values& values, const std::string& name, const std::string& word)
{
    try {
        values.set(name, word);
    } catch (const Error& error) {
        throw Error(Failure::usage, text("--", error.what())); // it begins with the name
    }
}

} // namespace

Eye first_eye(const std::string& scene)
{
    const view::Orbit orbit = cli::default_orbit(scene);
    return {static_cast<double>(orbit.azimuth) * degrees, static_cast<double>(orbit.elevation) * degrees};
}

Wish first_wish(const cli::StartArguments& start)
{
    const cli::RenderArguments& picture = start.picture;
    Wish wish{picture.scene, picture.environment, {}, first_eye(picture.scene), {}};
    if (start.lights.size() > most_lights)
        throw Error(Failure::usage,
                    text("--light: ", start.lights.size(), " are more than a viewer's ", most_lights));
    set_lights(wish, start.lights);
    set_size(wish, picture.settings.width, picture.settings.height);
    for (const auto& [name, word] : start.words) {
        if (name == "camera")
            wish.eye = eye_of(word, picture.target);
        else if (name == "backend")
            wish.fixed.insert(wish.fixed.end(), {"--backend", word});
        else if (name == "density")
            wish.density = word;
        else if (name == "animation" || name == "moment")
            continue; // load_first knows which there are
        else if (name == "env-rotation")
            turn_environment(wish, cli::parse_number(word, name));
        else if (name != "size" && name != "target")
            set_option(wish.values, name, word);
    }
    if (!picture.settings.energy_compensation)
        wish.fixed.emplace_back("--no-energy-compensation");
    if (picture.display.dither)
        wish.fixed.emplace_back("--dither");
    return wish;
}

void look_through(Wish& wish, const scene::Scene& scene, const std::string& camera)
{
    cli::RenderArguments asked;
    asked.scene = wish.scene;
    asked.camera_node = camera;
    const view::Camera found = cli::choose_camera(asked, scene);
    const glm::dvec3 back(found.back), position(found.position);
    const scene::Bounds bounds = scene::framed_bounds(scene);
    const double far_enough = 1e-3 * radius_of(bounds);
    double distance = std::max(glm::dot(position - middle_of(bounds), back), far_enough);
    // What the camera is to show at least is seen where the picture is narrower, too.
    const double wider = std::max(static_cast<double>(found.aspect) * wish.height / wish.width, 1.0);
    if (found.vertical_fov > 0.0f) {
        const double half = wider * std::tan(0.5 * static_cast<double>(found.vertical_fov));
        const double fov = 2.0 * std::atan(half) * degrees;
        wish.values.set("fov", number_word(std::clamp(fov, least_fov, most_fov)));
    } else {
        const double fov = std::stod(wish.values["fov"]) / degrees;
        distance = 0.5 * wider * static_cast<double>(found.vertical_size) / std::tan(0.5 * fov);
    }
    wish.eye = {std::atan2(back.x, back.z) * degrees, std::asin(std::clamp(back.y, -1.0, 1.0)) * degrees,
                distance, scene.origin + position - distance * back};
}

void set_lights(Wish& wish, const std::vector<std::string>& lights)
{
    if (lights.size() > most_lights)
        throw Error(Failure::usage, text("lights: ", lights.size(), " are more than ", most_lights));
    for (const std::string& light : lights)
        cli::parse_light(light, "light");
    wish.lights = lights;
}

void animate(Wish& wish, const std::vector<scene::AnimationInfo>& animations, double number)
{
    if (!(number < static_cast<double>(animations.size())) || (number >= 0.0 && number != std::floor(number)))
        throw Error(Failure::usage, text("there is no animation ", number));
    wish.moment = 0.0;
    wish.animation.clear();
    if (number < 0.0)
        return;
    // By its name, unless that cannot be typed, or is another's name or number, too.
    const auto index = static_cast<std::size_t>(number);
    const std::string& name = animations[index].name;
    if (std::none_of(name.begin(), name.end(),
                     [](char c) { return std::iscntrl(static_cast<unsigned char>(c)); }))
        wish.animation = name;
    if (animation_of(wish, animations) != static_cast<int>(index))
        wish.animation = text(index);
}

int animation_of(const Wish& wish, const std::vector<scene::AnimationInfo>& animations)
{
    cli::RenderArguments arguments;
    arguments.animation = wish.animation;
    try {
        const std::optional<scene::Moment> moment = cli::moment_asked(arguments, animations);
        return moment ? moment->animation : -1;
    } catch (const Error&) {
        return -1;
    }
}

void turn_environment(Wish& wish, double degrees)
{
    const double before = std::stod(wish.values["env-rotation"]);
    const double turned = std::remainder(before + std::fmod(degrees, 360.0), 360.0);
    wish.values.set("env-rotation", number_word(turned));
}

void set_size(Wish& wish, double width, double height)
{
    const auto side = [](double length) {
        return std::isfinite(length) ? std::clamp(length, 16.0, 16384.0) : 16.0;
    };
    const double w = side(width), h = side(height);
    const double shrink = std::min(1.0, std::sqrt(most_pixels / (w * h)));
    wish.width = std::max(16, static_cast<int>(w * shrink));
    wish.height = std::max(16, static_cast<int>(h * shrink));
    while (static_cast<double>(wish.width) * wish.height > most_pixels)
        --(wish.width > wish.height ? wish.width : wish.height);
}

std::vector<std::string> words_of(const Wish& wish)
{
    std::vector<std::string> words = {"render", as_file(wish.scene)};
    const auto add = [&](const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
    };
    if (wish.environment != "kitchen")
        add({"--env", as_file(wish.environment)});
    add({"--size", text(wish.width, "x", wish.height)});
    add(wish.eye.options());
    add(wish.values.options(scene::is_builtin(wish.scene)));
    for (const std::string& light : wish.lights)
        add({"--light", light});
    if (!wish.density.empty() && scene::is_builtin(wish.scene))
        add({"--density", wish.density});
    if (!wish.animation.empty() && !scene::is_builtin(wish.scene)) // its name may look like an option
        add({text("--animation=", wish.animation), text("--moment=", number_word(wish.moment))});
    add(wish.fixed);
    return words;
}

std::string command_of(const Wish& wish, const std::string& output)
{
    std::string command = "lambent";
    for (const std::string& word : words_of(wish))
        command += text(" ", shell_quoted(word));
    return text(command, " -o ", shell_quoted(output));
}

cli::RenderArguments arguments_of(const Wish& wish)
{
    std::vector<std::string> words = words_of(wish);
    words.insert(words.begin(), "lambent");
    words.insert(words.end(), {"-o", "picture.png"});
    std::vector<const char*> pointers;
    pointers.reserve(words.size());
    for (const std::string& word : words)
        pointers.push_back(word.c_str());
    const cli::Arguments parsed = cli::parse_arguments(static_cast<int>(pointers.size()), pointers.data());
    if (const auto* arguments = std::get_if<cli::RenderArguments>(&parsed))
        return *arguments;
    throw Error(Failure::usage, "the picture asked for is none"); // a name such as --help
}

} // namespace lambent::viewer
