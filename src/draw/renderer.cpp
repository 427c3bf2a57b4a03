#include "draw/renderer.h"

namespace lambent::draw {

Frame Renderer::draw(const environment::Environment* environment, const Settings& settings,
                     const std::function<void(float)>& progress)
{
    const std::unique_ptr<Drawing> drawing = start(environment, settings);
    Drawing::GoOn go_on;
    if (progress)
        go_on = [&](float done) {
            progress(done);
            return true;
        };
    drawing->advance(go_on);
    return drawing->take();
}

} // namespace lambent::draw
