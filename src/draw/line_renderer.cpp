#include "draw/line_renderer.h"

#include "view/widened_scene.h"

#include <optional>
#include <utility>

namespace lambent::draw {
namespace {

class LineRenderer : public Renderer {
public:
    LineRenderer(std::unique_ptr<Renderer> renderer, const scene::Scene& scene)
        : renderer_(std::move(renderer)), scene_(&scene)
    {
    }

    std::unique_ptr<Drawing> start(const environment::Environment* environment,
                                   const Settings& settings) override;

    void pose(const scene::Scene& scene) override
    {
        scene_ = &scene;
        widened_.reset();
    }

    Device device() const override { return renderer_->device(); }

    // Makes the triangles of points and lines face this picture's camera.
    void face(const Settings& settings)
    {
        if (!widened_)
            widened_.emplace(*scene_, view::WidenedScene::Others::shown);
        if (widened_->face(settings))
            renderer_->pose(widened_->scene());
    }

private:
    std::unique_ptr<Renderer> renderer_;
    const scene::Scene* scene_;
    std::optional<view::WidenedScene> widened_; ///< empty until made for the current pose
};

// Faces its own camera again in each step, because other pictures may have been drawn in between.
class LineDrawing : public Drawing {
public:
    LineDrawing(LineRenderer& renderer, std::unique_ptr<Drawing> drawing, const Settings& settings)
        : renderer_(renderer), drawing_(std::move(drawing)), settings_(settings)
    {
    }

    bool advance(const GoOn& go_on) override
    {
        renderer_.face(settings_);
        return drawing_->advance(go_on);
    }

    Frame take() override { return drawing_->take(); }
    void refine(int passes) override { drawing_->refine(passes); }
    Frame picture(const Check& check) const override { return drawing_->picture(check); }

private:
    LineRenderer& renderer_;
    std::unique_ptr<Drawing> drawing_;
    const Settings settings_;
};

std::unique_ptr<Drawing> LineRenderer::start(const environment::Environment* environment,
                                             const Settings& settings)
{
    face(settings);
    return std::make_unique<LineDrawing>(*this, renderer_->start(environment, settings), settings);
}

} // namespace

std::unique_ptr<Renderer> with_lines(std::unique_ptr<Renderer> renderer, const scene::Scene& scene)
{
    if (!scene::has_lines(scene))
        return renderer;
    return std::make_unique<LineRenderer>(std::move(renderer), scene);
}

} // namespace lambent::draw
