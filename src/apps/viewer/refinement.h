// A picture at rest that goes on getting better.
#pragma once

#include "apps/common/picture_audit.h"
#include "apps/viewer/plan.h"
#include "draw/renderer.h"

#include <functional>
#include <memory>
#include <optional>

namespace lambent::viewer {

/// Measures the error of a picture with bounces of light, gives it as many rays again, and so on. Used by the drawing
/// thread alone.
class Refinement {
public:
    /// The error from which a picture is good enough, and the passes after which it stays as it is.
    static constexpr double wanted_error = 0.01;
    static constexpr int most_passes = 1024;

    /// `drawing`: of the plan's picture, complete. `check`: as of draw::Drawing::picture.
    Refinement(const Plan& plan, std::unique_ptr<draw::Drawing> drawing, const draw::Drawing::Check& check);

    DrawState::Serial serial() const { return serial_; }

    /// Takes one step: a measurement, or more rays. Returns false where `may_continue` did, or lets its exception pass:
    /// then the same step is to be taken again. It is called often, by any thread. The model must be in the plan's pose.
    bool advance(const std::function<bool()>& may_continue);

    /// Whether there are no more steps.
    bool is_finished() const
    {
        return measured_ && (!error_ || error_->relative_rmse <= wanted_error || passes_ >= most_passes);
    }

    const draw::Frame& frame() const { return frame_; }
    int passes() const { return passes_; }
    bool is_measured() const { return measured_; }

    /// Of frame(), as `lambent render` measures it; unset: not measured yet, or nothing can be measured.
    const std::optional<audit::Error>& error() const { return error_; }

private:
    void measure(const std::function<bool()>& may_continue);
    bool add_rays(const std::function<bool()>& may_continue);

    DrawState::Serial serial_;
    cli::RenderArguments arguments_;
    std::shared_ptr<const scene::Scene> scene_; ///< used by audit_
    std::unique_ptr<draw::Drawing> drawing_;
    draw::Frame frame_;
    int passes_, asked_; ///< of the frame, and of the drawing
    bool measured_ = false;
    std::optional<audit::Error> error_;
    std::optional<cli::PictureAudit> audit_;
};

/// The error of the picture (RGBA before exposure) that `lambent render` writes into its file; nothing where that is not
/// measured. `before_each`: as of PictureAudit::error_of.
std::optional<audit::Error> error_in_file(const Plan& plan, const image::RadianceImage& picture,
                                          const std::function<void()>& before_each);

} // namespace lambent::viewer
