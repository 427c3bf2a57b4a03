// What a session wants drawn next, and what became of it.
#include "apps/common/picture_setup.h"
#include "apps/viewer/session.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambent::viewer {
namespace {

// A picture of more samples than this is preceded by one that is whole sooner.
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

// What is wished may not be there yet, or no longer: what was there before is drawn until it is.
bool Session::find_things(const ViewRequest& request)
{
    const cli::RenderArguments arguments = arguments_of(request);
    const Found<Model> model = assets_.model(arguments);
    const Found<const cli::LoadedEnvironment> environment = assets_.environment(request.asked.environment);
    pending_ = model.pending || environment.pending;
    const std::string error = !model.error.empty() ? model.error : environment.error;
    announce_ = announce_ || error != file_error_;
    file_error_ = error;
    const bool changed =
        (model.value && model.value != model_) || (environment.value && environment.value != environment_);
    if (model.value)
        model_ = model.value;
    if (environment.value)
        environment_ = environment.value;
    if (changed) {
        announce_ = true;
        forget_lost_animation();
        begin_anew();
    }
    has_things_ = model_ && environment_;
    is_wished_ = model.value && environment.value;
    return has_things_;
}

bool Session::is_compared() const
{
    const std::string& layer = request_.asked.shown;
    return layer == "reference" || layer == "error";
}

// Whether what is at rest can be compared now.
bool Session::find_trace()
{
    if (!is_compared() || rest_ != serial_ || traced_ == serial_)
        return false;
    if (trace_)
        return true;
    const Found<const RawEnvironment> raw = assets_.raw_environment(request_.asked.environment);
    if (!raw.value || raw.pending || drawn_.values.empty())
        return false; // it is being loaded, maybe again, or the environment's error has been said already
    TraceTask task;
    task.arguments = planned(Plan::Task::rest).arguments;
    task.shows_error = request_.asked.shown == "error";
    task.model = model_;
    task.environment = raw.value;
    trace_ = std::make_shared<Trace>(std::move(task), std::exchange(drawn_, {}));
    return true;
}

void Session::look_for_opening()
{
    if (opening_.name.empty())
        return;
    ViewRequest request = request_;
    (opening_.is_scene ? request.asked.scene : request.asked.environment) = opening_.name;
    if (opening_.is_scene) {
        request.eye = first_eye(request.asked.scene);
        request.asked.animation.clear();
    }
    bool pending = false, there = false;
    std::string error;
    try {
        const auto look = [&](const auto& found) {
            pending = found.pending;
            there = found.value != nullptr;
            error = found.error;
        };
        if (opening_.is_scene)
            look(assets_.model(arguments_of(request)));
        else
            look(assets_.environment(request.asked.environment));
    } catch (const Error& problem) {
        error = problem.what();
    }
    if (error.empty() && pending)
        return;
    opening_.name.clear();
    announce_ = true;
    if (!there || !error.empty()) {
        set_error(error);
        return;
    }
    request_ = std::move(request);
    if (opening_.is_scene)
        play_from(std::nullopt);
    input_ = std::max(input_, opening_.input);
    begin_anew();
}

std::optional<Plan::Task> Session::task_now(Clock::time_point now, Clock::time_point& wake, bool may_be_long)
{
    if (!saves_.empty() && may_be_long)
        return Plan::Task::save;
    if (in_flight_ >= most_in_flight)
        return std::nullopt;
    if (place_)
        return Plan::Task::pick;
    if (drawn_serial_ != serial_)
        return Plan::Task::moving;
    const bool is_coming = pending_ && !is_wished_; // what is there is only what was there before
    return may_be_long && !is_coming ? long_task_now(now, wake) : std::nullopt;
}

// For what does not move.
std::optional<Plan::Task> Session::long_task_now(Clock::time_point now, Clock::time_point& wake)
{
    if (find_trace())
        return Plan::Task::trace;
    if (rest_ == serial_)
        return std::nullopt;
    if (now - last_input_ < settle) {
        wake = std::min(wake, last_input_ + settle);
        return std::nullopt;
    }
    const int samples = request_.asked.settings.samples;
    return still_ != serial_ && samples > many_samples ? Plan::Task::still : Plan::Task::rest;
}

// As soon as what is wished is there: the picture is the one that its command writes.
void Session::plan_asked_save()
{
    if (is_wished_) {
        plan_save();
    } else if (!pending_) {
        save_kind_.clear();
        --unsaved_;
        set_error(text("nothing was saved: ", file_error_));
    }
}

// What moves until it is drawn is not in it.
void Session::plan_save()
{
    const std::string file = text("picture.", std::exchange(save_kind_, ""));
    try {
        saves_.push_back(planned(Plan::Task::save));
    } catch (const Error&) {
        --unsaved_;
        throw;
    }
    saves_.back().file = file;
    saves_.back().command = command_of(request_, file);
}

Plan Session::planned(Plan::Task task)
{
    Plan plan;
    plan.task = task;
    plan.arguments = arguments_of(request_);
    plan.layer = request_.asked.shown;
    plan.model = model_;
    plan.environment = environment_;
    plan.moment = request_.moment;
    plan.width = request_.asked.settings.width;
    plan.height = request_.asked.settings.height;
    plan.serial = serial_;
    plan.input = input_;
    const glm::dvec3& origin = model_->scene().origin;
    plan.arguments.settings.camera = cli::orbit_asked(plan.arguments, model_->bounds(), origin);
    plan.arguments.settings.lights = cli::lights_asked(plan.arguments, origin);
    if (task == Plan::Task::moving)
        plan.scale = pace_.scale();
    if (task == Plan::Task::pick)
        plan.scale = std::min(1.0, 320.0 / std::max(plan.width, plan.height));
    if (task == Plan::Task::moving || task == Plan::Task::pick)
        make_fast(plan.arguments, plan.scale);
    if (task == Plan::Task::still)
        plan.arguments.settings.samples = draw::split_sum_samples;
    if (task == Plan::Task::pick)
        plan.place = *std::exchange(place_, std::nullopt);
    plan.is_compared = task == Plan::Task::rest && is_compared();
    if (task == Plan::Task::trace)
        plan.trace = trace_;
    if (is_compared() || task == Plan::Task::save)
        plan.layer = "picture";
    plan.arguments.settings.layers = task == Plan::Task::pick || plan.layer != "picture";
    return plan;
}

std::optional<Plan> Session::plan_now(Clock::time_point now, Clock::time_point& wake, bool may_be_long)
{
    look_for_opening();
    go_on_playing(now, wake);
    if (!find_things(request_))
        return std::nullopt;
    if (!save_kind_.empty())
        plan_asked_save();
    const std::optional<Plan::Task> task = task_now(now, wake, may_be_long);
    if (!task)
        return std::nullopt;
    if (task == Plan::Task::save) {
        Plan plan = std::move(saves_.front());
        saves_.pop_front();
        return plan;
    }
    Plan plan = planned(*task);
    if (task != Plan::Task::pick)
        ++in_flight_;
    return plan;
}

std::optional<Plan> Session::plan(Clock::time_point now, Clock::time_point& wake, bool may_be_long)
{
    std::optional<Plan> plan;
    std::string state;
    {
        const std::lock_guard lock(mutex_);
        if (closed_)
            return std::nullopt;
        try {
            plan = plan_now(now, wake, may_be_long);
        } catch (const Error& error) { // nothing of this request can be drawn
            set_error(error.what());
            drawn_serial_ = still_ = rest_ = traced_ = serial_;
        }
        // Before the picture at rest: whoever sees that knows its command.
        if (std::exchange(announce_, false) || (plan && plan->task == Plan::Task::rest))
            state = state_now();
    }
    if (!state.empty())
        presenter_->say(state);
    return plan;
}

void Session::done(const Plan& plan, double milliseconds)
{
    const std::lock_guard lock(mutex_);
    if (plan.task == Plan::Task::moving) {
        pace_.made(plan.scale, milliseconds);
        drawn_serial_ = plan.serial;
    }
    if (plan.task == Plan::Task::save)
        --unsaved_;
    if (plan.task == Plan::Task::still)
        still_ = plan.serial;
    if (plan.task == Plan::Task::rest)
        rest_ = plan.serial;
}

void Session::drawn(const Plan& plan, image::RadianceImage light)
{
    const std::lock_guard lock(mutex_);
    if (plan.serial == serial_)
        drawn_ = std::move(light);
}

void Session::traced(const Plan& plan)
{
    const std::lock_guard lock(mutex_);
    traced_ = plan.serial;
    if (plan.serial == serial_)
        trace_.reset();
}

void Session::failed(const Plan& plan, const std::string& line)
{
    const std::lock_guard lock(mutex_);
    if (plan.task == Plan::Task::save)
        --unsaved_;
    if (plan.task != Plan::Task::save && plan.task != Plan::Task::pick)
        seen();
    if (line.empty())
        return;
    set_error(line);
    // Not again until something changes.
    drawn_serial_ = still_ = rest_ = traced_ = plan.serial;
}

void Session::paused(const Plan& plan)
{
    const std::lock_guard lock(mutex_);
    if (plan.task == Plan::Task::save)
        saves_.push_front(plan);
    else
        seen(); // what was not shown
}

void Session::complain(const std::string& line)
{
    const std::lock_guard lock(mutex_);
    set_error(line);
}

void Session::picked(const glm::dvec3& point, const Plan& plan)
{
    const std::lock_guard lock(mutex_);
    request_.eye.look_at(world(), point + plan.model->scene().origin);
    touch(place_input_);
}

} // namespace lambent::viewer
