#include "apps/common/reference_setup.h"

#include "apps/common/input_names.h"
#include "apps/common/picture_setup.h"
#include "environment/builtin/builtin.h"
#include "environment/panorama/panorama.h"

namespace lambent::cli {
namespace {

// The limits if the user gives none. Mirrors under a small lamp may never reach this noise, so samples end them.
constexpr double usual_noise = 0.01;
constexpr int usual_samples = 1024;

} // namespace

std::optional<image::RadianceImage> load_raw_environment(const std::string& name, Warnings& warnings)
{
    if (name == "none")
        return std::nullopt;
    if (environment::is_builtin(name))
        return environment::make_builtin(name);
    check_environment_name(name);
    return environment::load_unpacked_panorama(name, warnings);
}

reference::Settings reference_settings(const ReferenceArguments& arguments, const scene::Scene& scene)
{
    reference::Settings settings;
    static_cast<view::Picture&>(settings) = arguments.picture.settings;
    settings.camera = choose_camera(arguments.picture, scene);
    settings.lights = lights_asked(arguments.picture, scene.origin);
    settings.bounces = arguments.picture.bounces;
    settings.seed = arguments.seed;
    settings.first_surfaces = arguments.denoise;
    settings.cut = 1.0 / static_cast<double>(arguments.picture.display.exposure);
    if (arguments.seconds)
        settings.seconds = *arguments.seconds;
    const bool no_limit = !arguments.samples && !arguments.noise && !arguments.seconds;
    if (arguments.samples || no_limit)
        settings.samples = arguments.samples.value_or(usual_samples);
    settings.noise = arguments.noise.value_or(no_limit ? usual_noise : 0.0);
    // With --spp alone every pixel gets exactly that number.
    settings.adaptive = !arguments.uniform && (settings.noise > 0.0 || arguments.seconds);
    return settings;
}

} // namespace lambent::cli
