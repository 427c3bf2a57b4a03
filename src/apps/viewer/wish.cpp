#include "apps/viewer/wish.h"

#include "apps/cli/values.h"
#include "base/error.h"
#include "base/text.h"
#include "scene/builtin.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace lambent::viewer {
namespace {

// A file whose name looks like an option is none.
std::string as_file(const std::string& name)
{
    return name.starts_with('-') ? text("./", name) : name;
}

} // namespace

void set_lights(Wish& wish, const std::vector<std::string>& lights)
{
    if (lights.size() > most_lights)
        throw Error(Failure::usage, text("lights: ", lights.size(), " are more than ", most_lights));
    for (const std::string& light : lights)
        cli::parse_light(light, "light");
    wish.lights = lights;
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
    return words;
}

std::string shell_quoted(const std::string& word)
{
    const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:+=@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
        return word;
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
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
