#include "apps/cli/picture_setup.h"

#include "apps/cli/values.h"
#include "base/text.h"
#include "scene/gltf.h"

namespace lambent::cli {
// Charts are looked at from the front; everything else three quarters from the front, a little from above.
view::Orbit default_orbit(const std::string& scene)
{
    if (scene == "grid" || scene == "furnace")
        return {};
    if (scene == "report")
        return {0.0f, radians(20.0), 0.0f};
    return {radians(30.0), radians(20.0), 0.0f};
}

scene::Scene load_scene(const RenderArguments& arguments, Warnings& warnings)
{
    if (scene::is_builtin(arguments.scene))
        return scene::make_builtin(arguments.scene, arguments.builtin);
    return scene::load_gltf(arguments.scene, warnings);
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
    return orbit_asked(arguments, scene::bounds(scene));
}

view::Camera orbit_asked(const RenderArguments& arguments, const scene::Bounds& bounds)
{
    const float aspect =
        static_cast<float>(arguments.settings.width) / static_cast<float>(arguments.settings.height);
    const view::Orbit orbit = arguments.orbit.value_or(default_orbit(arguments.scene));
    const scene::Bounds around =
        arguments.target ? scene::Bounds{*arguments.target, *arguments.target} : bounds;
    return view::orbit_camera(around, orbit, arguments.vertical_fov, aspect);
}

} // namespace lambent::cli
