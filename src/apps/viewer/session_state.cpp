// What a session tells its viewer.
#include "apps/viewer/session.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace lambent::viewer {
namespace {

// A file may have thousands of animations.
constexpr std::size_t most_animations = 200;

} // namespace

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
            playing_since_.has_value()};
}

std::string Session::state_now() const
{
    const Playing playing = playing_now();
    nlohmann::ordered_json state = {{"type", "state"},
                                    {"scene", request_.asked.scene},
                                    {"environment", request_.asked.environment},
                                    {"values", to_json(request_.asked)},
                                    {"lights", request_.asked.light_words},
                                    {"command", command_of(shown_request(), "picture.png")},
                                    {"animation", playing.number},
                                    {"seconds", playing.now.seconds},
                                    {"moment", playing.moment},
                                    {"playing", playing.on},
                                    {"width", request_.asked.settings.width},
                                    {"height", request_.asked.settings.height},
                                    {"loading", is_loading_ || !opening_.name.empty()},
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
    // File names that are not UTF-8 would otherwise throw.
    return state.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

ViewRequest Session::request() const
{
    const std::lock_guard lock(mutex_);
    return request_;
}

ViewRequest Session::shown() const
{
    const std::lock_guard lock(mutex_);
    return shown_request();
}

double Session::scale() const
{
    const std::lock_guard lock(mutex_);
    return arguments_of(request_).settings.bounces > 0 ? light_pace_.scale() : pace_.scale();
}

} // namespace lambent::viewer
