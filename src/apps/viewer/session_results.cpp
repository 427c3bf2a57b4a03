// What became of a session's plans.
#include "apps/viewer/session.h"

#include <utility>

namespace lambent::viewer {

void Session::picture_finished(const Plan& plan, double milliseconds)
{
    using Stage = DrawState::Stage;
    const std::lock_guard lock(mutex_);
    switch (plan.task) {
    case Plan::Task::moving:
        (plan.arguments.settings.bounces > 0 ? light_pace_ : pace_).made(plan.scale, milliseconds);
        draw_state_.picture_finished(plan.serial, Stage::moving);
        break;
    case Plan::Task::still:
        draw_state_.picture_finished(plan.serial, Stage::still);
        break;
    case Plan::Task::rest:
        rest_time_ = Clock::now();
        draw_state_.picture_finished(plan.serial, Stage::rest);
        break;
    case Plan::Task::save:
        draw_state_.save_finished();
        break;
    case Plan::Task::pick:
    case Plan::Task::refine:
    case Plan::Task::trace:
        break;
    }
}

void Session::light_drawn(const Plan& plan, image::RadianceImage light)
{
    const std::lock_guard lock(mutex_);
    if (draw_state_.is_current(plan.serial))
        drawn_ = std::move(light);
}

void Session::refined(const Plan& plan, int passes)
{
    std::string state;
    {
        const std::lock_guard lock(mutex_);
        if (!draw_state_.is_current(plan.serial))
            return;
        shown_passes_ = passes;
        state = state_now();
    }
    presenter_->say(state);
}

void Session::refinement_finished(const Plan& plan)
{
    draw_state_.picture_finished(plan.serial, DrawState::Stage::finished);
}

void Session::trace_finished(const Plan& plan)
{
    const std::lock_guard lock(mutex_);
    if (!draw_state_.is_current(plan.serial))
        return;
    draw_state_.picture_finished(plan.serial, DrawState::Stage::finished);
    trace_.reset();
}

void Session::plan_failed(const Plan& plan, const std::string& line)
{
    const std::lock_guard lock(mutex_);
    if (plan.task == Plan::Task::save)
        draw_state_.save_finished();
    else if (plan.task != Plan::Task::pick)
        draw_state_.picture_left();
    if (line.empty())
        return;
    set_error(line);
    draw_state_.request_failed(plan.serial);
}

void Session::plan_paused(const Plan& plan)
{
    const std::lock_guard lock(mutex_);
    if (plan.task == Plan::Task::save)
        saves_.push_front(plan);
    else
        draw_state_.picture_left(); // nothing of it was shown
}

void Session::point_picked(const glm::dvec3& point, const Plan& plan)
{
    const std::lock_guard lock(mutex_);
    request_.eye.look_at(world(), point + plan.model->scene().origin);
    note_input(pick_input_);
}

void Session::report_error(const std::string& line)
{
    const std::lock_guard lock(mutex_);
    set_error(line);
}

} // namespace lambent::viewer
