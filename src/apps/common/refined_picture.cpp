#include "apps/common/refined_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace lambent::cli {
namespace {

using Clock = std::chrono::steady_clock;

double square(double x)
{
    return x * x;
}

class Refining {
public:
    Refining(draw::Drawing& drawing, int passes, const RefineLimits& limits, const Measure& measure,
             const RefineProgress& progress)
        : drawing_(drawing), limits_(limits), measure_(measure), progress_(progress), passes_(passes)
    {
    }

    void run()
    {
        advance();
        for (;;) {
            if (limits_.error && is_good())
                return;
            const int more = next_passes();
            if (more < 1)
                return;
            shown_.reset();
            drawing_.refine(more);
            const Clock::time_point start = Clock::now();
            advance();
            seconds_of_pass_ = seconds_since(start) / more;
            passes_ += more;
        }
    }

    int passes() const { return passes_; }
    const std::optional<audit::Error>& error() const { return error_; }

    // The picture; to be called once.
    draw::Frame take() { return shown_ ? std::move(*shown_) : drawing_.take(); }

private:
    static double seconds_since(Clock::time_point start)
    {
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

    void advance()
    {
        drawing_.advance([&](float done) {
            progress_(share_done(done), error_);
            return true;
        });
    }

    // By the time if that is limited, else by the passes that the error still needs, as far as is known.
    float share_done(float drawn) const
    {
        if (limits_.seconds)
            return std::min(static_cast<float>(seconds_since(start_) / *limits_.seconds), 1.0f);
        const double wanted = needed_ > 0.0 ? needed_ : 2.0 * passes_;
        return static_cast<float>(std::min(static_cast<double>(drawn) * passes_ / wanted, 1.0));
    }

    // Whether the error is small enough. The error of p passes is about e^2 = bias^2 + noise^2 / p.
    bool is_good()
    {
        const std::optional<audit::Error> before = std::exchange(error_, {});
        const Clock::time_point start = Clock::now();
        shown_ = drawing_.picture({});
        error_ = measure_(shown_->radiance, number_++);
        seconds_of_measurement_ = seconds_since(start);
        // One that is small enough may be so by chance; the measurement that is told must agree.
        if (error_ && error_->relative_rmse <= *limits_.error)
            error_ = measure_(shown_->radiance, 0);
        if (!error_ || error_->relative_rmse <= *limits_.error)
            return true;
        const double now = square(error_->relative_rmse);
        double noise = now * passes_;
        if (before && measured_passes_ < passes_)
            noise = std::clamp(
                (square(before->relative_rmse) - now) / (1.0 / measured_passes_ - 1.0 / passes_), 0.0, noise);
        const double bias = now - noise / passes_, left = square(*limits_.error) - bias;
        needed_ = left > 0.0 ? noise / left : 0.0;
        measured_passes_ = passes_;
        return false;
    }

    // A quarter more to twice as many in all: a measurement is not exact, and neither is what is concluded from it.
    int next_passes() const
    {
        double more = passes_;
        if (needed_ > 0.0)
            more = std::clamp(1.1 * needed_ - passes_, 0.25 * passes_, more);
        if (!limits_.error)
            more = most_passes;
        if (limits_.seconds)
            more = std::min(more, passes_in_time());
        return static_cast<int>(
            std::clamp(std::ceil(more - 1e-9), 0.0, static_cast<double>(most_passes - passes_)));
    }

    // Before a pass was timed alone one is tried. The filter, and what is yet unknown, take about another pass.
    double passes_in_time() const
    {
        const double left = *limits_.seconds - seconds_since(start_) - seconds_of_measurement_;
        if (!(seconds_of_pass_ > 0.0))
            return left > 0.5 * seconds_since(start_) ? 1.0 : 0.0;
        const double passes = std::floor(left / seconds_of_pass_) - 1.0;
        return passes > 8.0 ? std::floor(0.5 * passes) : passes; // times differ from pass to pass
    }

    draw::Drawing& drawing_;
    const RefineLimits& limits_;
    const Measure& measure_;
    const RefineProgress& progress_;
    const Clock::time_point start_ = Clock::now();
    int passes_, measured_passes_ = 0;
    std::uint32_t number_ = 1; ///< 0 is left for the finished picture
    double seconds_of_pass_ = 0.0, seconds_of_measurement_ = 0.0;
    double needed_ = 0.0; ///< passes; 0: unknown
    std::optional<audit::Error> error_;
    std::optional<draw::Frame> shown_; ///< the present picture, if it was measured
};

} // namespace

RefinedPicture refined_picture(std::unique_ptr<draw::Drawing> drawing, int passes, const RefineLimits& limits,
                               const Measure& measure, const RefineProgress& progress)
{
    Refining refining(*drawing, passes, limits, measure, progress);
    refining.run();
    return {refining.take(), refining.passes(), refining.error()};
}

} // namespace lambent::cli
