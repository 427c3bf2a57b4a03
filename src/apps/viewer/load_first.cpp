#include "apps/viewer/load_first.h"

#include "apps/common/input_names.h"
#include "apps/common/picture_setup.h"

#include <algorithm>

namespace lambent::viewer {

ViewRequest load_first(const cli::StartArguments& arguments, AssetCache& assets, const cli::Console& console)
{
    ViewRequest request = starting_request(arguments);
    const cli::RenderArguments first = arguments_of(request);
    cli::check_scene_name(first.scene);
    assets.load(first);
    const std::shared_ptr<Model> model = assets.model(first).value;
    const std::vector<scene::AnimationInfo>& animations = model->scene().animations;
    if (const std::optional<scene::Moment> moment = cli::moment_asked(arguments.picture, animations)) {
        animate(request, animations, moment->animation);
        request.moment =
            std::min(moment->seconds, animations[static_cast<std::size_t>(moment->animation)].seconds);
    }
    console.warn(model->warnings());
    console.warn(assets.environment(first.environment).value->warnings);
    if (const std::string& camera = arguments.picture.camera_node; !camera.empty())
        look_through(request, model->scene(), camera);
    return request;
}

} // namespace lambent::viewer
