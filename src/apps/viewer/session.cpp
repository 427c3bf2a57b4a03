#include "apps/viewer/session.h"

#include "apps/cli/picture_setup.h"
#include "base/error.h"
#include "base/text.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lambent::viewer {
namespace {

// A picture of more samples than this is preceded by one that is whole sooner.
constexpr int many_samples = 80;

// A file may have thousands.
constexpr std::size_t most_animations = 200;

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

Session::Session(Wish start, Stock& stock, std::shared_ptr<Presenter> presenter)
    : stock_(stock), presenter_(std::move(presenter)), start_(std::move(start)), wish_(start_)
{
    find_things(wish_);
}

void Session::touch(std::uint64_t input)
{
    input_ = std::max(input_, input);
    last_input_ = Clock::now();
    ++serial_;
    // Memory that nobody needs any more.
    drawn_ = {};
    trace_.reset();
}

Eye::World Session::world() const
{
    if (!model_)
        return {};
    cli::RenderArguments arguments = arguments_of(wish_);
    arguments.orbit->distance = 0.0f;
    arguments.target.reset();
    const view::Camera camera = cli::orbit_asked(arguments, model_->bounds());
    return {model_->bounds(), glm::length(glm::dvec3(camera.position) - middle_of(model_->bounds()))};
}

void Session::change(std::uint64_t input, const Change& change)
{
    const std::lock_guard lock(mutex_);
    Wish changed = wish_;
    change(changed, world());
    arguments_of(changed); // throws where the command would be refused
    wish_ = std::move(changed);
    error_.clear();
    touch(input);
}

void Session::reset(std::uint64_t input)
{
    const std::lock_guard lock(mutex_);
    const Wish old = std::exchange(wish_, start_);
    wish_.scene = old.scene;
    wish_.environment = old.environment;
    wish_.width = old.width;
    wish_.height = old.height;
    playing_.reset();
    if (wish_.scene != start_.scene) {
        wish_.eye = first_eye(wish_.scene);
        wish_.animation.clear();
    }
    error_.clear();
    announce_ = true;
    touch(input);
}

void Session::animate(std::uint64_t input, double number)
{
    const std::lock_guard lock(mutex_);
    if (model_)
        viewer::animate(wish_, model_->scene().animations, number);
    playing_.reset();
    announce_ = true;
    touch(input);
}

void Session::seek(std::uint64_t input, double seconds)
{
    const std::lock_guard lock(mutex_);
    wish_.moment = std::isfinite(seconds) ? std::clamp(seconds, 0.0, duration()) : 0.0;
    if (playing_)
        playing_ = Clock::now();
    touch(input);
}

void Session::play(std::uint64_t input, bool on)
{
    const std::lock_guard lock(mutex_);
    playing_.reset();
    announce_ = true;
    touch(input);
    if (!on || !model_ || model_->scene().animations.empty())
        return;
    if (wish_.animation.empty())
        viewer::animate(wish_, model_->scene().animations, 0);
    playing_ = Clock::now();
}

// Of the animation that is wished; 0 without one.
double Session::duration() const
{
    if (!model_)
        return 0.0;
    const std::vector<scene::AnimationInfo>& animations = model_->scene().animations;
    const int number = animation_of(wish_, animations);
    return number < 0 ? 0.0 : animations[static_cast<std::size_t>(number)].seconds;
}

// The wish is that of the moment: whoever looks late sees fewer of them.
void Session::go_on_playing(Clock::time_point now, Clock::time_point& wake)
{
    const double seconds = duration();
    if (!playing_ || !(seconds > 0.0) || in_flight_ >= most_in_flight)
        return;
    wake = std::min(wake, *playing_ + least_step);
    if (now - *playing_ < least_step)
        return;
    wish_.moment = std::fmod(wish_.moment + std::chrono::duration<double>(now - *playing_).count(), seconds);
    playing_ = now;
    wake = now + least_step;
    touch(0);
}

void Session::open_scene(const std::string& name)
{
    const std::lock_guard lock(mutex_);
    opening_ = {true, name};
    announce_ = true;
    error_.clear();
}

void Session::open_environment(const std::string& name)
{
    const std::lock_guard lock(mutex_);
    opening_ = {false, name};
    announce_ = true;
    error_.clear();
}

bool Session::is_opening() const
{
    const std::lock_guard lock(mutex_);
    return !opening_.name.empty();
}

void Session::focus(double x, double y)
{
    const std::lock_guard lock(mutex_);
    place_ = {std::clamp(x, 0.0, 1.0), std::clamp(y, 0.0, 1.0)};
}

void Session::save(const std::string& kind)
{
    const std::lock_guard lock(mutex_);
    if (kind != "png" && kind != "jpg")
        throw Error(Failure::usage, text("save: '", kind.substr(0, 20), "' is none of png, jpg"));
    if (!save_kind_.empty())
        throw Error(Failure::usage, "save: a picture is being saved already");
    save_kind_ = kind;
    saving_ = true;
}

void Session::seen()
{
    int flying = in_flight_;
    while (flying > 0 && !in_flight_.compare_exchange_weak(flying, flying - 1)) {
    }
}

void Session::close()
{
    closed_ = true;
}

bool Session::is_hungry() const
{
    return !closed_ && serial_ != drawn_serial_ && in_flight_ < most_in_flight;
}

void Session::set_error(const std::string& line)
{
    announce_ = announce_ || line != error_;
    error_ = line;
}

// What is wished may not be there yet, or no longer: what was there before is drawn until it is.
bool Session::find_things(const Wish& wish)
{
    const cli::RenderArguments arguments = arguments_of(wish);
    const Found<Model> model = stock_.model(arguments);
    const Found<const cli::LoadedEnvironment> environment = stock_.environment(wish.environment);
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
        ++serial_;
    }
    return model_ && environment_;
}

bool Session::is_compared() const
{
    const std::string& layer = wish_.values["layer"];
    return layer == "reference" || layer == "error";
}

// Whether what is at rest can be compared now.
bool Session::find_trace()
{
    if (!is_compared() || rest_ != serial_ || traced_ == serial_)
        return false;
    if (trace_)
        return true;
    const Found<const RawEnvironment> raw = stock_.raw_environment(wish_.environment);
    if (!raw.value || drawn_.values.empty())
        return false; // it is being loaded, or the environment's error has been said already
    TraceTask task;
    task.arguments = planned(Plan::Task::rest).arguments;
    task.bounces = std::stoi(wish_.values["bounces"]);
    task.shows_error = wish_.values["layer"] == "error";
    task.model = model_;
    task.environment = raw.value;
    trace_ = std::make_shared<Trace>(std::move(task), std::exchange(drawn_, {}));
    return true;
}

void Session::look_for_opening()
{
    if (opening_.name.empty())
        return;
    Wish wish = wish_;
    (opening_.is_scene ? wish.scene : wish.environment) = opening_.name;
    if (opening_.is_scene) {
        wish.eye = first_eye(wish.scene);
        wish.animation.clear();
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
            look(stock_.model(arguments_of(wish)));
        else
            look(stock_.environment(wish.environment));
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
    wish_ = std::move(wish);
    if (opening_.is_scene)
        playing_.reset();
    ++serial_;
}

std::optional<Plan::Task> Session::task_now(Clock::time_point now, Clock::time_point& wake)
{
    if (!save_kind_.empty())
        return Plan::Task::save;
    if (in_flight_ >= most_in_flight)
        return std::nullopt;
    if (place_)
        return Plan::Task::pick;
    if (drawn_serial_ != serial_)
        return Plan::Task::moving;
    if (find_trace())
        return Plan::Task::trace;
    if (rest_ == serial_)
        return std::nullopt;
    if (now - last_input_ < settle) {
        wake = std::min(wake, last_input_ + settle);
        return std::nullopt;
    }
    const int samples = std::stoi(wish_.values["samples"]);
    return still_ != serial_ && samples > many_samples ? Plan::Task::still : Plan::Task::rest;
}

Plan Session::planned(Plan::Task task)
{
    Plan plan;
    plan.task = task;
    plan.arguments = arguments_of(wish_);
    plan.layer = wish_.values["layer"];
    plan.model = model_;
    plan.environment = environment_;
    plan.moment = wish_.moment;
    plan.width = wish_.width;
    plan.height = wish_.height;
    plan.serial = serial_;
    plan.input = input_;
    plan.arguments.settings.camera = cli::orbit_asked(plan.arguments, model_->bounds());
    if (task == Plan::Task::moving)
        plan.scale = pace_.scale();
    if (task == Plan::Task::pick)
        plan.scale = std::min(1.0, 320.0 / std::max(plan.width, plan.height));
    if (task == Plan::Task::moving || task == Plan::Task::pick)
        make_fast(plan.arguments, plan.scale);
    if (task == Plan::Task::still)
        plan.arguments.settings.samples = draw::split_sum_samples;
    if (task == Plan::Task::save) {
        plan.file = text("picture.", std::exchange(save_kind_, ""));
        plan.command = command_of(wish_, plan.file);
        plan.layer = "picture";
    }
    if (task == Plan::Task::pick)
        plan.place = *std::exchange(place_, std::nullopt);
    plan.is_compared = task == Plan::Task::rest && is_compared();
    if (task == Plan::Task::trace)
        plan.trace = trace_;
    if (is_compared())
        plan.layer = "picture";
    plan.arguments.settings.layers = task == Plan::Task::pick || plan.layer != "picture";
    return plan;
}

std::optional<Plan> Session::plan(Clock::time_point now, Clock::time_point& wake)
{
    std::optional<Plan> plan;
    std::string state;
    {
        const std::lock_guard lock(mutex_);
        if (closed_)
            return std::nullopt;
        look_for_opening();
        go_on_playing(now, wake);
        if (find_things(wish_))
            if (const std::optional<Plan::Task> task = task_now(now, wake)) {
                plan = planned(*task);
                if (task != Plan::Task::save && task != Plan::Task::pick)
                    ++in_flight_;
            }
        if (std::exchange(announce_, false))
            state = state_now();
    }
    if (!state.empty())
        presenter_->say(state);
    return plan;
}

void Session::done(const Plan& plan, double milliseconds)
{
    std::string state;
    {
        const std::lock_guard lock(mutex_);
        if (plan.task == Plan::Task::moving) {
            pace_.made(plan.scale, milliseconds);
            drawn_serial_ = plan.serial;
        }
        if (plan.task == Plan::Task::save)
            saving_ = !save_kind_.empty();
        if (plan.task == Plan::Task::still)
            still_ = plan.serial;
        if (plan.task == Plan::Task::rest) {
            rest_ = plan.serial;
            state = state_now();
        }
    }
    if (!state.empty())
        presenter_->say(state);
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
        saving_ = !save_kind_.empty();
    if (plan.task != Plan::Task::save && plan.task != Plan::Task::pick)
        seen();
    if (line.empty())
        return; // overtaken: it is planned again
    set_error(line);
    // Not again until something changes.
    drawn_serial_ = still_ = rest_ = traced_ = plan.serial;
}

void Session::picked(const glm::dvec3& point, const Plan&)
{
    const std::lock_guard lock(mutex_);
    wish_.eye.look_at(world(), point);
    touch(0);
}

std::string Session::state() const
{
    const std::lock_guard lock(mutex_);
    return state_now();
}

Playing Session::playing() const
{
    const std::lock_guard lock(mutex_);
    return playing_now();
}

Playing Session::playing_now() const
{
    if (!model_)
        return {};
    const std::vector<scene::AnimationInfo>& all = model_->scene().animations;
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), most_animations));
    return {{all.begin(), end}, animation_of(wish_, all), wish_.moment, playing_.has_value()};
}

std::string Session::state_now() const
{
    const Playing playing = playing_now();
    nlohmann::ordered_json state = {{"type", "state"},
                                    {"scene", wish_.scene},
                                    {"environment", wish_.environment},
                                    {"values", to_json(wish_.values)},
                                    {"lights", wish_.lights},
                                    {"command", command_of(wish_, "picture.png")},
                                    {"animation", playing.number},
                                    {"moment", playing.moment},
                                    {"playing", playing.on},
                                    {"width", wish_.width},
                                    {"height", wish_.height},
                                    {"loading", pending_ || !opening_.name.empty()},
                                    {"error", !error_.empty() ? error_ : file_error_}};
    state["animations"] = nlohmann::ordered_json::array();
    for (const scene::AnimationInfo& animation : playing.animations)
        state["animations"].push_back(
            {{"name", one_line(animation.name).substr(0, 100)}, {"seconds", animation.seconds}});
    state["warnings"] = nlohmann::ordered_json::array();
    if (model_)
        for (const std::string& warning : model_->warnings())
            if (state["warnings"].size() < 8)
                state["warnings"].push_back(one_line(warning).substr(0, 300));
    // File names need not be UTF-8.
    return state.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Wish Session::wish() const
{
    const std::lock_guard lock(mutex_);
    return wish_;
}

double Session::scale() const
{
    const std::lock_guard lock(mutex_);
    return pace_.scale();
}

} // namespace lambent::viewer
