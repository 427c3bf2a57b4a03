#include "apps/common/picture_setup.h"

#include "apps/common/input_names.h"
#include "apps/options/values.h"
#include "base/text.h"

#include <algorithm>
#include <charconv>

namespace lambent::cli {
namespace {

// The index of the animation that has the word as its name, else as its number.
std::optional<std::size_t> index_of(const std::string& word, std::span<const scene::AnimationInfo> animations)
{
    for (std::size_t i = 0; i < animations.size(); ++i)
        if (animations[i].name == word)
            return i;
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool whole = error == std::errc() && end == word.data() + word.size();
    return whole && number < animations.size() ? std::optional(number) : std::nullopt;
}

std::string names_of(std::span<const scene::AnimationInfo> animations)
{
    constexpr std::size_t most = 20;
    std::string names;
    for (std::size_t i = 0; i < std::min(animations.size(), most); ++i)
        names += text(i == 0 ? "" : ", ", animations[i].name.substr(0, 40));
    return one_line(names + (animations.size() > most ? ", ..." : ""));
}

} // namespace

// Charts are seen from the front, other scenes from 20 degrees above and, but for the report's, 30 degrees to the side.
view::Orbit default_orbit(const std::string& scene)
{
    if (scene == "grid" || scene == "furnace")
        return {};
    if (scene == "report")
        return {0.0f, radians(20.0), 0.0f};
    return {radians(30.0), radians(20.0), 0.0f};
}

scene::Scene load_scene(const RenderArguments& arguments, Warnings& warnings, InputFiles* inputs)
{
    if (scene::is_builtin(arguments.scene))
        return scene::make_builtin(arguments.scene, arguments.builtin);
    check_scene_name(arguments.scene);
    const scene::GltfFile file(arguments.scene, warnings, {true, {}});
    for (const std::filesystem::path& beside : file.files())
        if (inputs)
            inputs->add(beside);
    return file.scene(moment_asked(arguments, file.animations()), warnings);
}

InputFiles inputs_named(const RenderArguments& arguments)
{
    return InputFiles({arguments.scene, arguments.environment});
}

std::optional<scene::Moment> moment_asked(const RenderArguments& arguments,
                                          std::span<const scene::AnimationInfo> animations)
{
    if (arguments.animation.empty() && !arguments.moment)
        return std::nullopt;
    const char* const option = arguments.animation.empty() ? "--moment" : "--animation";
    if (animations.empty())
        throw Error(Failure::usage, text(option, ": ", arguments.scene, " has no animations"));
    const std::optional<std::size_t> index =
        arguments.animation.empty() ? std::size_t{0} : index_of(arguments.animation, animations);
    if (!index)
        throw Error(Failure::usage, text(option, ": ", arguments.scene, " has no animation '",
                                         arguments.animation, "' (it has ", names_of(animations), ")"));
    return scene::Moment{static_cast<int>(*index), arguments.moment.value_or(0.0)};
}

view::Camera choose_camera(const RenderArguments& arguments, const scene::Scene& scene)
{
    if (!arguments.camera_node.empty()) {
        for (const scene::Camera& camera : scene.cameras)
            if (camera.name == arguments.camera_node)
                return view::from_scene(camera);
        throw Error(Failure::usage, text("--camera-node: ", arguments.scene, " has no camera '",
                                         arguments.camera_node, "' (it has ", scene.cameras.size(), ")"));
    }
    return orbit_asked(arguments, scene::framed_bounds(scene), scene.origin);
}

std::vector<scene::Light> lights_asked(const RenderArguments& arguments, const glm::dvec3& origin)
{
    std::vector<scene::Light> lights = arguments.settings.lights;
    for (std::size_t i = 0; i < std::min(lights.size(), arguments.light_places.size()); ++i)
        if (lights[i].kind != scene::LightKind::directional)
            lights[i].position = glm::vec3(arguments.light_places[i] - origin);
    return lights;
}

view::Camera orbit_asked(const RenderArguments& arguments, const scene::Bounds& bounds,
                         const glm::dvec3& origin)
{
    const float aspect =
        static_cast<float>(arguments.settings.width) / static_cast<float>(arguments.settings.height);
    const view::Orbit orbit = arguments.orbit.value_or(default_orbit(arguments.scene));
    const glm::vec3 target(arguments.target.value_or(origin) - origin);
    const scene::Bounds around = arguments.target ? scene::Bounds{target, target} : bounds;
    return view::orbit_camera(around, orbit, arguments.vertical_fov, aspect);
}

} // namespace lambent::cli
