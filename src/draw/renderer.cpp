#include "draw/renderer.h"

#include "base/error.h"

namespace lambent::draw {

void Drawing::refine(int)
{
    throw Error(Failure::usage, "a picture without bounces of light cannot be refined");
}

Frame Drawing::picture(const Check&) const
{
    throw Error(Failure::usage, "a picture without bounces of light can only be taken");
}

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
