#include "apps/viewer/refinement.h"

#include "apps/options/rules.h"
#include "base/error.h"

#include <utility>

namespace lambent::viewer {
namespace {

// The number of the measurement that `lambent render` makes.
constexpr std::uint32_t first_measurement = 0;

// Runs `measure`; where the scene cannot be traced, there is no error to tell.
template <class Measure>
std::optional<audit::Error> measured_if_possible(const Measure& measure)
{
    try {
        return measure();
    } catch (const Error& failure) {
        if (failure.failure() != Failure::no_device)
            throw;
        return std::nullopt;
    }
}

} // namespace

Refinement::Refinement(const Plan& plan, std::unique_ptr<draw::Drawing> drawing,
                       const draw::Drawing::Check& check)
    : serial_(plan.serial), arguments_(plan.arguments), scene_(plan.model->whole_scene()),
      drawing_(std::move(drawing)), frame_(drawing_->picture(check)), passes_(plan.arguments.settings.passes),
      asked_(passes_)
{
}

bool Refinement::advance(const std::function<bool()>& may_continue)
{
    if (measured_)
        return add_rays(may_continue);
    measure(may_continue);
    return true;
}

void Refinement::measure(const std::function<bool()>& may_continue)
{
    error_ = measured_if_possible([&] {
        if (!audit_)
            audit_.emplace(arguments_, *scene_);
        return audit_->error_of(frame_.radiance, first_measurement, [&] { may_continue(); });
    });
    measured_ = true;
}

bool Refinement::add_rays(const std::function<bool()>& may_continue)
{
    if (asked_ == passes_) {
        drawing_->refine(passes_);
        asked_ = 2 * passes_;
    }
    if (!drawing_->advance([&](float) { return may_continue(); }))
        return false;
    frame_ = drawing_->picture([&] { may_continue(); });
    passes_ = asked_;
    measured_ = false;
    error_.reset();
    return true;
}

std::optional<audit::Error> error_in_file(const Plan& plan, const image::RadianceImage& picture,
                                          const std::function<void()>& before_each)
{
    if (!cli::is_audited(plan.arguments))
        return std::nullopt;
    return measured_if_possible([&] {
        const std::shared_ptr<const scene::Scene> scene = plan.model->whole_scene();
        return cli::PictureAudit(plan.arguments, *scene).error_of(picture, first_measurement, before_each);
    });
}

} // namespace lambent::viewer
