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

    // The current renderer, and whether it is the fallback.
    Renderer& present() { return *renderer_; }
    bool is_rescued() const { return !make_other_; }

    // Switches to the fallback if the error calls for it. Returns whether it did.
    bool goes_on_after(const Error& error)
    {
        if (error.failure() != Failure::no_device || is_rescued())
            return false;
        warn_(error.what());
        renderer_.reset(); // frees its memory before the fallback is made
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
    const scene::Scene* posed_ = nullptr;                   ///< null: as constructed
    std::function<std::unique_ptr<Renderer>()> make_other_; ///< null after the switch
    std::function<void(const std::string&)> warn_;
};

// A drawing that starts again with the fallback once the renderer has switched to it.
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

    // Devices draw without bounces: a drawing that can be refined is the fallback's.
    void refine(int passes) override { present().refine(passes); }
    Frame picture(const Check& check) const override { return drawing_->picture(check); }

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
    std::unique_ptr<Drawing> drawing_; ///< null until started
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
