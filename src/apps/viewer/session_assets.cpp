// The scenes, environments and references that a session draws with.
#include "apps/viewer/session.h"
#include "base/error.h"

#include <algorithm>
#include <utility>

namespace lambent::viewer {

// Returns whether there is a scene and an environment to draw with. Until those of the request are loaded, or if they
// cannot be, the ones before stay.
bool Session::find_assets()
{
    const Found<Model> model = assets_.model(arguments_of(request_));
    const Found<const cli::LoadedEnvironment> environment = assets_.environment(request_.asked.environment);
    is_loading_ = model.pending || environment.pending;
    const std::string error = !model.error.empty() ? model.error : environment.error;
    has_news_ = has_news_ || error != file_error_;
    file_error_ = error;
    const bool changed =
        (model.value && model.value != model_) || (environment.value && environment.value != environment_);
    if (model.value)
        model_ = model.value;
    if (environment.value)
        environment_ = environment.value;
    if (changed) {
        has_news_ = true;
        forget_lost_animation();
        request_view();
    }
    const bool drawable = model_ && environment_;
    draw_state_.set_drawable(drawable);
    is_loaded_ = model.value && environment.value;
    return drawable;
}

bool Session::is_compared() const
{
    const std::string& layer = request_.asked.shown;
    return layer == "reference" || layer == "error";
}

// Returns whether the picture at rest can be compared with a reference now; begins one if there is none yet.
bool Session::find_trace()
{
    if (!is_compared() || draw_state_.stage() != DrawState::Stage::rest)
        return false;
    if (trace_)
        return true;
    const Found<const RawEnvironment> raw = assets_.raw_environment(request_.asked.environment);
    if (!raw.value || raw.pending || drawn_.values.empty())
        return false; // being loaded, perhaps again, or file_error_ has the reason already
    TraceTask task;
    task.arguments = make_plan(Plan::Task::rest).arguments;
    task.shows_error = request_.asked.shown == "error";
    task.model = model_;
    task.environment = raw.value;
    trace_ = std::make_shared<Trace>(std::move(task), std::exchange(drawn_, {}));
    return true;
}

// Shows what was to be opened once it is loaded, or reports why it cannot be.
void Session::finish_opening()
{
    if (opening_.name.empty())
        return;
    ViewRequest request = request_;
    (opening_.is_scene ? request.asked.scene : request.asked.environment) = opening_.name;
    if (opening_.is_scene) {
        request.eye = default_camera(request.asked.scene);
        request.asked.animation.clear();
    }
    bool is_loading = false, is_loaded = false;
    std::string error;
    try {
        const auto look = [&](const auto& found) {
            is_loading = found.pending;
            is_loaded = found.value != nullptr;
            error = found.error;
        };
        if (opening_.is_scene)
            look(assets_.model(arguments_of(request)));
        else
            look(assets_.environment(request.asked.environment));
    } catch (const Error& problem) {
        error = problem.what();
    }
    if (error.empty() && is_loading)
        return;
    opening_.name.clear();
    has_news_ = true;
    if (!is_loaded || !error.empty()) {
        set_error(error);
        return;
    }
    request_ = std::move(request);
    if (opening_.is_scene)
        set_playing(std::nullopt);
    input_ = std::max(input_, opening_.input);
    request_view();
}

} // namespace lambent::viewer
