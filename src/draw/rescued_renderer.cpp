#include "draw/rescued_renderer.h"

#include "base/error.h"

#include <utility>

namespace lambent::draw {
namespace {

class RescuedRenderer : public Renderer {
public:
    RescuedRenderer(std::unique_ptr<Renderer> device, std::function<std::unique_ptr<Renderer>()> make_other,
                    std::function<void(const std::string&)> warn)
        : renderer_(std::move(device)), make_other_(std::move(make_other)), warn_(std::move(warn))
    {
    }

    std::unique_ptr<Drawing> start(const environment::Environment* environment,
                                   const Settings& settings) override;

    // The one that draws now, and whether it is the second.
    Renderer& present() { return *renderer_; }
    bool is_rescued() const { return !make_other_; }

    // Whether another draws from now on.
    bool goes_on_after(const Error& error)
    {
        if (error.failure() != Failure::no_device || is_rescued())
            return false;
        warn_(error.what());
        renderer_.reset(); // before the other takes memory
        renderer_ = std::exchange(make_other_, nullptr)();
        if (posed_)
            renderer_->pose(*posed_);
        return true;
    }

    void pose(const scene::Scene& scene) override
    {
        posed_ = &scene;
        renderer_->pose(scene);
    }

    Device device() const override { return renderer_->device(); }

private:
    std::unique_ptr<Renderer> renderer_;
    const scene::Scene* posed_ = nullptr;                   ///< null: as it was made
    std::function<std::unique_ptr<Renderer>()> make_other_; ///< null: it was made
    std::function<void(const std::string&)> warn_;
};

// Begun anew by the other renderer, if that has come meanwhile.
class RescuedDrawing : public Drawing {
public:
    RescuedDrawing(RescuedRenderer& renderer, const environment::Environment* environment,
                   const Settings& settings)
        : renderer_(renderer), environment_(environment), settings_(settings)
    {
    }

    bool advance(const GoOn& go_on) override
    {
        try {
            return present().advance(go_on);
        } catch (const Error& error) {
            if (!renderer_.goes_on_after(error))
                throw;
        }
        return present().advance(go_on);
    }

    Frame take() override { return drawing_->take(); }

private:
    Drawing& present()
    {
        if (!drawing_ || by_rescuer_ != renderer_.is_rescued()) {
            drawing_ = renderer_.present().start(environment_, settings_);
            by_rescuer_ = renderer_.is_rescued();
        }
        return *drawing_;
    }

    RescuedRenderer& renderer_;
    const environment::Environment* environment_;
    const Settings settings_;
    std::unique_ptr<Drawing> drawing_; ///< null: not begun
    bool by_rescuer_ = false;
};

std::unique_ptr<Drawing> RescuedRenderer::start(const environment::Environment* environment,
                                                const Settings& settings)
{
    return std::make_unique<RescuedDrawing>(*this, environment, settings);
}

} // namespace

std::unique_ptr<Renderer> make_rescued_renderer(std::unique_ptr<Renderer> device,
                                                std::function<std::unique_ptr<Renderer>()> make_other,
                                                std::function<void(const std::string&)> warn)
{
    return std::make_unique<RescuedRenderer>(std::move(device), std::move(make_other), std::move(warn));
}

} // namespace lambent::draw
