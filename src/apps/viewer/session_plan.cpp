// What a session wants drawn next.
#include "apps/common/picture_setup.h"
#include "apps/viewer/session.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambent::viewer {
namespace {

// Where a picture has more samples than this, one with few samples is shown before it.
constexpr int many_samples = 80;

void make_fast(cli::RenderArguments& arguments, double scale)
{
    draw::Settings& settings = arguments.settings;
    settings.samples = std::min(settings.samples, draw::split_sum_samples);
    settings.edge_samples = 1;
    settings.mip_level = draw::MipLevel::matched;
    settings.width = std::max(1, static_cast<int>(std::lround(settings.width * scale)));
    settings.height = std::max(1, static_cast<int>(std::lround(settings.height * scale)));
}

} // namespace

std::optional<Plan::Task> Session::next_task(Clock::time_point now, Clock::time_point& wake, bool may_be_long)
{
    if (!saves_.empty() && may_be_long)
        return Plan::Task::save;
    if (!draw_state_.can_show_more())
        return std::nullopt;
    if (pick_place_)
        return Plan::Task::pick;
    if (draw_state_.stage() == DrawState::Stage::requested)
        return Plan::Task::moving;
    const bool is_outdated = is_loading_ && !is_loaded_; // the assets before are drawn, but not refined
    return may_be_long && !is_outdated ? next_long_task(now, wake) : std::nullopt;
}

// For a view at rest.
std::optional<Plan::Task> Session::next_long_task(Clock::time_point now, Clock::time_point& wake)
{
    if (find_trace())
        return Plan::Task::trace;
    const DrawState::Stage stage = draw_state_.stage();
    if (stage == DrawState::Stage::rest && is_refined()) {
        if (shown_passes_ > 0 || now - rest_time_ >= before_refining)
            return Plan::Task::refine;
        wake = std::min(wake, rest_time_ + before_refining);
        return std::nullopt;
    }
    if (stage >= DrawState::Stage::rest)
        return std::nullopt;
    if (now - input_time_ < settle) {
        wake = std::min(wake, input_time_ + settle);
        return std::nullopt;
    }
    const int samples = request_.asked.settings.samples;
    return stage < DrawState::Stage::still && samples > many_samples ? Plan::Task::still : Plan::Task::rest;
}

// Plans the requested save once the request's own assets are loaded: its bytes are those that the command writes.
void Session::plan_requested_save()
{
    if (is_loaded_) {
        plan_save();
    } else if (!is_loading_) {
        save_kind_.clear();
        draw_state_.save_finished();
        set_error(text("the picture was not saved: ", file_error_));
    }
}

// The plan keeps the present request: inputs until it is drawn do not change the saved picture.
void Session::plan_save()
{
    const std::string file = text("picture.", std::exchange(save_kind_, ""));
    try {
        saves_.push_back(make_plan(Plan::Task::save));
    } catch (const Error&) {
        draw_state_.save_finished();
        throw;
    }
    saves_.back().file = file;
    saves_.back().command = command_of(shown_request(), file);
}

// The request of the picture that is shown: it may have had more passes than were asked for.
ViewRequest Session::shown_request() const
{
    ViewRequest request = request_;
    if (shown_passes_ > 0)
        request.asked.settings.passes = shown_passes_;
    return request;
}

// Whether the picture at rest goes on getting better.
bool Session::is_refined() const
{
    return arguments_of(request_).settings.bounces > 0 && request_.asked.shown == "picture" && !is_compared();
}

// A picture of a moving view has light from surface to surface as the picture before knew it, at a scale that holds the
// rate; where none does, it has no shadows.
void Session::make_moving(Plan& plan)
{
    constexpr double slowest_ms = 50.0;
    draw::Settings& settings = plan.arguments.settings;
    plan.lacks_shadows = settings.bounces > 0 && light_pace_.is_slower_than(slowest_ms);
    if (plan.lacks_shadows)
        settings.bounces = 0;
    settings.passes = 1;
    settings.keeps_known_light = true;
    plan.scale = (settings.bounces > 0 ? light_pace_ : pace_).scale();
    make_fast(plan.arguments, plan.scale);
}

Plan Session::make_plan(Plan::Task task)
{
    Plan plan;
    plan.task = task;
    plan.arguments = arguments_of(task == Plan::Task::save ? shown_request() : request_);
    plan.layer = request_.asked.shown;
    plan.model = model_;
    plan.environment = environment_;
    plan.moment = request_.moment;
    plan.width = request_.asked.settings.width;
    plan.height = request_.asked.settings.height;
    plan.serial = draw_state_.serial();
    plan.input = input_;
    const glm::dvec3& origin = model_->scene().origin;
    plan.arguments.settings.camera = cli::orbit_asked(plan.arguments, model_->bounds(), origin);
    plan.arguments.settings.lights = cli::lights_asked(plan.arguments, origin);
    if (task == Plan::Task::moving)
        make_moving(plan);
    if (task == Plan::Task::pick) {
        plan.scale = std::min(1.0, 320.0 / std::max(plan.width, plan.height));
        plan.arguments.settings.bounces = 0;
        make_fast(plan.arguments, plan.scale);
    }
    if (task == Plan::Task::still) {
        plan.arguments.settings.samples = draw::split_sum_samples;
        plan.arguments.settings.passes = 1;
    }
    if (task == Plan::Task::pick)
        plan.place = *std::exchange(pick_place_, std::nullopt);
    plan.is_compared = task == Plan::Task::rest && is_compared();
    plan.is_refined = (task == Plan::Task::rest || task == Plan::Task::refine) && is_refined();
    if (task == Plan::Task::trace)
        plan.trace = trace_;
    if (is_compared() || task == Plan::Task::save)
        plan.layer = "picture";
    plan.arguments.settings.layers = task == Plan::Task::pick || plan.layer != "picture";
    return plan;
}

std::optional<Plan> Session::next_plan(Clock::time_point now, Clock::time_point& wake, bool may_be_long)
{
    finish_opening();
    advance_animation(now, wake);
    if (!find_assets())
        return std::nullopt;
    if (!save_kind_.empty())
        plan_requested_save();
    const std::optional<Plan::Task> task = next_task(now, wake, may_be_long);
    if (!task)
        return std::nullopt;
    if (task == Plan::Task::save) {
        Plan plan = std::move(saves_.front());
        saves_.pop_front();
        return plan;
    }
    Plan plan = make_plan(*task);
    if (task != Plan::Task::pick)
        draw_state_.picture_started();
    return plan;
}

std::optional<Plan> Session::plan(Clock::time_point now, Clock::time_point& wake, bool may_be_long)
{
    std::optional<Plan> plan;
    std::string state;
    {
        const std::lock_guard lock(mutex_);
        if (draw_state_.is_closed())
            return std::nullopt;
        try {
            plan = next_plan(now, wake, may_be_long);
        } catch (const Error& error) {
            set_error(error.what());
            draw_state_.request_failed(draw_state_.serial());
        }
        // Also sent before each picture at rest, so that the viewer then has its command.
        if (std::exchange(has_news_, false) || (plan && plan->task == Plan::Task::rest))
            state = state_now();
    }
    if (!state.empty())
        presenter_->say(state);
    return plan;
}

} // namespace lambent::viewer
