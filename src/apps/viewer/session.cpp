#include "apps/viewer/session.h"

#include "apps/common/picture_setup.h"
#include "base/error.h"
#include "base/text.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambent::viewer {
namespace {

// A file may have thousands.
constexpr std::size_t most_animations = 200;

} // namespace

Session::Session(ViewRequest start, AssetCache& assets, std::shared_ptr<Presenter> presenter)
    : assets_(assets), presenter_(std::move(presenter)), start_(std::move(start)), request_(start_)
{
    find_things(request_);
}

void Session::touch(std::uint64_t input)
{
    input_ = std::max(input_, input);
    last_input_ = Clock::now();
    begin_anew();
}

// Another picture is wanted: what belongs to the old one goes.
void Session::begin_anew()
{
    ++serial_;
    drawn_ = {};
    trace_.reset();
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
    touch(input);
}

void Session::reset(std::uint64_t input)
{
    const std::lock_guard lock(mutex_);
    const ViewRequest old = std::exchange(request_, start_);
    request_.asked.scene = old.asked.scene;
    request_.asked.environment = old.asked.environment;
    request_.asked.settings.width = old.asked.settings.width;
    request_.asked.settings.height = old.asked.settings.height;
    play_from(std::nullopt);
    if (request_.asked.scene != start_.asked.scene) {
        request_.eye = first_eye(request_.asked.scene);
        request_.asked.animation.clear();
    }
    forget_lost_animation();
    error_.clear();
    announce_ = true;
    touch(input);
}

void Session::animate(std::uint64_t input, double number)
{
    const std::lock_guard lock(mutex_);
    if (model_)
        viewer::animate(request_, model_->scene().animations, number);
    play_from(std::nullopt);
    announce_ = true;
    touch(input);
}

void Session::seek(std::uint64_t input, double seconds)
{
    const std::lock_guard lock(mutex_);
    request_.moment = std::isfinite(seconds) ? std::clamp(seconds, 0.0, duration()) : 0.0;
    if (playing_)
        playing_ = Clock::now();
    touch(input);
}

void Session::play(std::uint64_t input, bool on)
{
    const std::lock_guard lock(mutex_);
    play_from(std::nullopt);
    announce_ = true;
    touch(input);
    if (!on || !model_ || model_->scene().animations.empty())
        return;
    if (request_.asked.animation.empty())
        viewer::animate(request_, model_->scene().animations, 0);
    play_from(Clock::now());
}

void Session::play_from(const std::optional<Clock::time_point>& now)
{
    playing_ = now;
    moves_ = now && duration() > 0.0;
}

// A file that was loaded again may have others.
void Session::forget_lost_animation()
{
    if (!model_ || request_.asked.animation.empty() ||
        animation_of(request_, model_->scene().animations) >= 0)
        return;
    request_.asked.animation.clear();
    play_from(std::nullopt);
}

// Of the animation that is wished; 0 without one.
double Session::duration() const
{
    if (!model_)
        return 0.0;
    const std::vector<scene::AnimationInfo>& animations = model_->scene().animations;
    const int number = animation_of(request_, animations);
    return number < 0 ? 0.0 : animations[static_cast<std::size_t>(number)].seconds;
}

// The request is that of the moment: whoever looks late sees fewer of them.
void Session::go_on_playing(Clock::time_point now, Clock::time_point& wake)
{
    if (!playing_)
        return;
    const double seconds = duration();
    if (!(seconds > 0.0) || in_flight_ >= most_in_flight)
        return;
    wake = std::min(wake, *playing_ + least_step);
    if (now - *playing_ < least_step)
        return;
    request_.moment =
        std::fmod(request_.moment + std::chrono::duration<double>(now - *playing_).count(), seconds);
    playing_ = now;
    wake = now + least_step;
    touch(0);
}

void Session::open_scene(const std::string& name, std::uint64_t input)
{
    const std::lock_guard lock(mutex_);
    opening_ = {true, name, input};
    announce_ = true;
    error_.clear();
}

void Session::open_environment(const std::string& name, std::uint64_t input)
{
    const std::lock_guard lock(mutex_);
    opening_ = {false, name, input};
    announce_ = true;
    error_.clear();
}

bool Session::is_opening() const
{
    const std::lock_guard lock(mutex_);
    return !opening_.name.empty();
}

void Session::focus(double x, double y, std::uint64_t input)
{
    const std::lock_guard lock(mutex_);
    place_ = {std::clamp(x, 0.0, 1.0), std::clamp(y, 0.0, 1.0)};
    place_input_ = input;
}

void Session::save(const std::string& kind)
{
    const std::lock_guard lock(mutex_);
    if (kind != "png" && kind != "jpg")
        throw Error(Failure::usage, text("save: '", kind.substr(0, 20), "' is none of png, jpg"));
    if (unsaved_ >= most_saves || !save_kind_.empty())
        throw Error(Failure::usage, "save: a picture is being saved already");
    save_kind_ = kind;
    ++unsaved_;
    if (find_things(request_))
        plan_asked_save();
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
    return !closed_ && has_things_ && (moves_ || serial_ != drawn_serial_) && in_flight_ < most_in_flight;
}

void Session::set_error(const std::string& line)
{
    announce_ = announce_ || line != error_;
    error_ = line;
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
    const int number = animation_of(request_, all);
    return {{all.begin(), end},
            number,
            number < 0 ? scene::AnimationInfo{"none", 0.0} : all[static_cast<std::size_t>(number)],
            request_.moment,
            playing_.has_value()};
}

std::string Session::state_now() const
{
    const Playing playing = playing_now();
    nlohmann::ordered_json state = {{"type", "state"},
                                    {"scene", request_.asked.scene},
                                    {"environment", request_.asked.environment},
                                    {"values", to_json(request_.asked)},
                                    {"lights", request_.asked.light_words},
                                    {"command", command_of(request_, "picture.png")},
                                    {"animation", playing.number},
                                    {"seconds", playing.now.seconds},
                                    {"moment", playing.moment},
                                    {"playing", playing.on},
                                    {"width", request_.asked.settings.width},
                                    {"height", request_.asked.settings.height},
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

ViewRequest Session::request() const
{
    const std::lock_guard lock(mutex_);
    return request_;
}

double Session::scale() const
{
    const std::lock_guard lock(mutex_);
    return pace_.scale();
}

} // namespace lambent::viewer
