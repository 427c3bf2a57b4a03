#include "apps/viewer/load_first.h"

#include "apps/common/picture_setup.h"

#include <algorithm>

namespace lambent::viewer {

Wish load_first(const cli::StartArguments& arguments, Stock& stock, const cli::Console& console)
{
    Wish wish = first_wish(arguments);
    const cli::RenderArguments first = arguments_of(wish);
    stock.load(first);
    const std::shared_ptr<Model> model = stock.model(first).value;
    const std::vector<scene::AnimationInfo>& animations = model->scene().animations;
    if (const std::optional<scene::Moment> moment = cli::moment_asked(arguments.picture, animations)) {
        animate(wish, animations, moment->animation);
        wish.moment =
            std::min(moment->seconds, animations[static_cast<std::size_t>(moment->animation)].seconds);
    }
    console.warn(model->warnings());
    console.warn(stock.environment(first.environment).value->warnings);
    if (const std::string& camera = arguments.picture.camera_node; !camera.empty())
        look_through(wish, model->scene(), camera);
    return wish;
}

} // namespace lambent::viewer
