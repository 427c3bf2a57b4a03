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

    Frame draw(const environment::Environment* environment, const Settings& settings,
               const std::function<void(float)>& progress) override
    {
        if (!make_other_)
            return renderer_->draw(environment, settings, progress);
        try {
            return renderer_->draw(environment, settings, progress);
        } catch (const Error& error) {
            if (error.failure() != Failure::no_device)
                throw;
            warn_(error.what());
        }
        renderer_.reset(); // before the other takes memory
        renderer_ = std::exchange(make_other_, nullptr)();
        if (posed_)
            renderer_->pose(*posed_);
        return renderer_->draw(environment, settings, progress);
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

} // namespace

std::unique_ptr<Renderer> make_rescued_renderer(std::unique_ptr<Renderer> device,
                                                std::function<std::unique_ptr<Renderer>()> make_other,
                                                std::function<void(const std::string&)> warn)
{
    return std::make_unique<RescuedRenderer>(std::move(device), std::move(make_other), std::move(warn));
}

} // namespace lambent::draw
