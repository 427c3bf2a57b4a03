#include "apps/viewer/session.h"

#include "apps/common/picture_setup.h"
#include "base/error.h"
#include "base/text.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambent::viewer {

Session::Session(ViewRequest start, AssetCache& assets, std::shared_ptr<Presenter> presenter)
    : assets_(assets), presenter_(std::move(presenter)), start_(std::move(start)), request_(start_)
{
    find_assets();
}

void Session::note_input(std::uint64_t input)
{
    input_ = std::max(input_, input);
    input_time_ = Clock::now();
    request_view();
}

void Session::request_view()
{
    draw_state_.request_view();
    drawn_ = {};
    trace_.reset();
    has_news_ = has_news_ || shown_passes_ != 0;
    shown_passes_ = 0;
}

OrbitCamera::World Session::world() const
{
    if (!model_)
        return {};
    cli::RenderArguments arguments = arguments_of(request_);
    arguments.orbit->distance = 0.0f;
    arguments.target.reset();
    const glm::dvec3& origin = model_->scene().origin;
    const view::Camera camera = cli::orbit_asked(arguments, model_->bounds(), origin);
    return {model_->bounds(), glm::length(glm::dvec3(camera.position) - middle_of(model_->bounds())), origin};
}

void Session::change(std::uint64_t input, const Change& change)
{
    const std::lock_guard lock(mutex_);
    ViewRequest changed = request_;
    change(changed, world());
    request_ = std::move(changed);
    error_.clear();
    note_input(input);
}

void Session::reset(std::uint64_t input)
{
    const std::lock_guard lock(mutex_);
    const ViewRequest old = std::exchange(request_, start_);
    request_.asked.scene = old.asked.scene;
    request_.asked.environment = old.asked.environment;
    request_.asked.settings.width = old.asked.settings.width;
    request_.asked.settings.height = old.asked.settings.height;
    set_playing(std::nullopt);
    if (request_.asked.scene != start_.asked.scene) {
        request_.eye = default_camera(request_.asked.scene);
        request_.asked.animation.clear();
    }
    forget_lost_animation();
    error_.clear();
    has_news_ = true;
    note_input(input);
}

void Session::animate(std::uint64_t input, double number)
{
    const std::lock_guard lock(mutex_);
    if (model_)
        viewer::animate(request_, model_->scene().animations, number);
    set_playing(std::nullopt);
    has_news_ = true;
    note_input(input);
}

void Session::seek(std::uint64_t input, double seconds)
{
    const std::lock_guard lock(mutex_);
    request_.moment = std::isfinite(seconds) ? std::clamp(seconds, 0.0, duration()) : 0.0;
    if (playing_since_)
        playing_since_ = Clock::now();
    note_input(input);
}

void Session::play(std::uint64_t input, bool on)
{
    const std::lock_guard lock(mutex_);
    set_playing(std::nullopt);
    has_news_ = true;
    note_input(input);
    if (!on || !model_ || model_->scene().animations.empty())
        return;
    if (request_.asked.animation.empty())
        viewer::animate(request_, model_->scene().animations, 0);
    set_playing(Clock::now());
}

void Session::set_playing(const std::optional<Clock::time_point>& now)
{
    playing_since_ = now;
    draw_state_.set_animated(now && duration() > 0.0);
}

// A file that was loaded again may no longer have the chosen animation.
void Session::forget_lost_animation()
{
    if (!model_ || request_.asked.animation.empty() ||
        animation_of(request_, model_->scene().animations) >= 0)
        return;
    request_.asked.animation.clear();
    set_playing(std::nullopt);
}

// Of the chosen animation in seconds; 0 without one.
double Session::duration() const
{
    if (!model_)
        return 0.0;
    const std::vector<scene::AnimationInfo>& animations = model_->scene().animations;
    const int number = animation_of(request_, animations);
    return number < 0 ? 0.0 : animations[static_cast<std::size_t>(number)].seconds;
}

// Sets the request to the present moment of the animation: slow drawing shows fewer frames, at the same speed.
void Session::advance_animation(Clock::time_point now, Clock::time_point& wake)
{
    if (!playing_since_)
        return;
    const double seconds = duration();
    if (!(seconds > 0.0) || !draw_state_.can_show_more())
        return;
    wake = std::min(wake, *playing_since_ + least_step);
    if (now - *playing_since_ < least_step)
        return;
    request_.moment =
        std::fmod(request_.moment + std::chrono::duration<double>(now - *playing_since_).count(), seconds);
    playing_since_ = now;
    wake = now + least_step;
    note_input(0);
}

void Session::open(Opening opening)
{
    opening_ = std::move(opening);
    has_news_ = true;
    error_.clear();
}

void Session::open_scene(const std::string& name, std::uint64_t input)
{
    const std::lock_guard lock(mutex_);
    open({true, name, input});
}

void Session::open_environment(const std::string& name, std::uint64_t input)
{
    const std::lock_guard lock(mutex_);
    open({false, name, input});
}

bool Session::is_opening() const
{
    const std::lock_guard lock(mutex_);
    return !opening_.name.empty();
}

void Session::focus(double x, double y, std::uint64_t input)
{
    const std::lock_guard lock(mutex_);
    pick_place_ = {std::clamp(x, 0.0, 1.0), std::clamp(y, 0.0, 1.0)};
    pick_input_ = input;
}

void Session::save(const std::string& kind)
{
    const std::lock_guard lock(mutex_);
    if (kind != "png" && kind != "jpg")
        throw Error(Failure::usage, text("save: '", kind.substr(0, 20), "' is neither png nor jpg"));
    if (draw_state_.unsaved() >= most_saves || !save_kind_.empty())
        throw Error(Failure::usage, "save: another picture is still being saved");
    save_kind_ = kind;
    draw_state_.save_requested();
    if (find_assets())
        plan_requested_save();
}

void Session::set_error(const std::string& line)
{
    has_news_ = has_news_ || line != error_;
    error_ = line;
}

} // namespace lambent::viewer
