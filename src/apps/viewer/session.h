// One viewer: what it wants to see, and what is to be drawn next for it.
#pragma once

#include "apps/viewer/pace.h"
#include "apps/viewer/shown_picture.h"
#include "apps/viewer/asset_cache.h"
#include "apps/viewer/trace.h"
#include "apps/viewer/view_request.h"

#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace lambent::viewer {

using Clock = std::chrono::steady_clock;

/// One piece of work for the drawing thread.
struct Plan {
    enum class Task { moving, still, rest, trace, save, pick };
    Task task = Task::moving;
    cli::RenderArguments arguments; ///< with the camera, at the size to draw
    std::string layer;              ///< "picture", or of the frame's layers
    std::shared_ptr<Model> model;
    std::shared_ptr<const cli::LoadedEnvironment> environment;
    double scale = 1.0;
    double moment = 0.0;           ///< as ShownPicture::moment
    int width = 0, height = 0;     ///< as wished
    std::uint64_t serial = 0;      ///< of the request
    std::uint64_t input = 0;       ///< as ShownPicture::input
    std::shared_ptr<Trace> trace;  ///< trace: to go on with
    bool is_compared = false;      ///< rest: a trace is to follow
    std::string file, command;     ///< save
    std::array<double, 2> place{}; ///< pick: in parts of the picture, from its top left

    /// Whether it may take long: then others have their turn meanwhile.
    bool is_long() const { return task != Task::moving && task != Task::pick; }
};

/// What a scene's animations are doing.
struct Playing {
    std::vector<scene::AnimationInfo> animations; ///< of the scene that is shown; of very many the first
    int number = -1;          ///< of the one that is wished, which need not be among these; -1: none
    scene::AnimationInfo now; ///< that one
    double moment = 0.0;      ///< seconds from its start
    bool on = false;
};

/// Inputs may come from any thread; planning and reports from the drawing thread.
class Session {
public:
    static constexpr int most_in_flight = 2;
    static constexpr int most_saves = 2;
    /// Nothing moves when there was no input for so long.
    static constexpr std::chrono::milliseconds settle{60};
    /// An animation is drawn at most so often.
    static constexpr std::chrono::milliseconds least_step{16};

    Session(ViewRequest start, AssetCache& assets, std::shared_ptr<Presenter> presenter);

    using Change = std::function<void(ViewRequest&, const OrbitCamera::World&)>;

    /// Changes what is wished, or nothing if `change` throws, which is passed on. `input` counts the viewer's inputs.
    void change(std::uint64_t input, const Change& change);

    /// Everything as at the start, but for the size.
    void reset(std::uint64_t input);

    /// An animation of the scene, by its number from 0, at its start; below 0: none. Throws Error(usage) for others. Nothing
    /// before the scene is loaded.
    void animate(std::uint64_t input, double number);

    /// To a moment of the animation, seconds; cut to what it has.
    void seek(std::uint64_t input, double seconds);

    /// Lets the animation go on, the first one if there is none yet, round and round, or stops it.
    void play(std::uint64_t input, bool on);

    Playing playing() const;

    /// Another scene or environment, once it is loaded; what cannot be is said in the state.
    void open_scene(const std::string& name, std::uint64_t input = 0);
    void open_environment(const std::string& name, std::uint64_t input = 0);

    /// Whether one is being opened: another asked for meanwhile takes its place.
    bool is_opening() const;

    /// The surface at this place, in parts of the picture from its top left, becomes its middle.
    void focus(double x, double y, std::uint64_t input = 0);

    /// The picture of now, or of when there is one, as a file: "png" or "jpg". Throws Error(usage) for others, or if
    /// most_saves are being saved.
    void save(const std::string& kind);

    /// Whether a picture is being saved: from save() until the presenter has it or the state says why not.
    bool is_saving() const { return unsaved_ > 0; }

    /// One picture was seen: the next may come.
    void seen();

    /// Nothing more is drawn.
    void close();

    /// What is to be drawn now, nothing long unless it may be; if nothing, `wake` may become sooner, when to ask again.
    std::optional<Plan> plan(Clock::time_point now, Clock::time_point& wake, bool may_be_long);

    /// A plan was carried out and shown; took so long in all.
    void done(const Plan& plan, double milliseconds);

    /// The light that was drawn by a plan that is compared.
    void drawn(const Plan& plan, image::RadianceImage light);

    /// The plan's trace has come to its end.
    void traced(const Plan& plan);

    /// The plan came to nothing: why, or nothing if it was no longer wanted.
    void failed(const Plan& plan, const std::string& line);

    /// The plan was begun and is planned again when it may go on.
    void paused(const Plan& plan);

    /// Something to be said about what is shown, in one line.
    void complain(const std::string& line);

    void picked(const glm::dvec3& point, const Plan& plan);

    /// Whether what is drawn by this plan is no longer wanted; what is saved always is.
    bool is_stale(const Plan& plan) const
    {
        return closed_ || (plan.task != Plan::Task::save && serial_ != plan.serial);
    }

    /// Whether a picture of something that moves is waited for.
    bool is_hungry() const;

    Presenter& presenter() { return *presenter_; }

    /// What is set, what it is called on the command line, and what is wrong: JSON.
    std::string state() const;

    ViewRequest request() const;
    double scale() const;

private:
    struct Opening {
        bool is_scene = false;
        std::string name; ///< empty: nothing is being opened
        std::uint64_t input = 0;
    };

    void touch(std::uint64_t input);
    void begin_anew();
    OrbitCamera::World world() const;
    void look_for_opening();
    bool find_things(const ViewRequest& request);
    bool find_trace();
    double duration() const;
    void forget_lost_animation();
    void play_from(const std::optional<Clock::time_point>& now);
    void go_on_playing(Clock::time_point now, Clock::time_point& wake);
    bool is_compared() const;
    void set_error(const std::string& line);
    std::optional<Plan::Task> task_now(Clock::time_point now, Clock::time_point& wake, bool may_be_long);
    std::optional<Plan::Task> long_task_now(Clock::time_point now, Clock::time_point& wake);
    Plan planned(Plan::Task task);
    void plan_asked_save();
    void plan_save();
    std::optional<Plan> plan_now(Clock::time_point now, Clock::time_point& wake, bool may_be_long);
    Playing playing_now() const;
    std::string state_now() const;

    mutable std::mutex mutex_;
    AssetCache& assets_;
    const std::shared_ptr<Presenter> presenter_;
    const ViewRequest start_;
    ViewRequest request_;
    Pace pace_;
    std::shared_ptr<Model> model_;
    std::shared_ptr<const cli::LoadedEnvironment> environment_;
    image::RadianceImage drawn_; ///< at rest; empty: not compared, or not yet drawn
    std::shared_ptr<Trace> trace_;
    Opening opening_;
    std::string file_error_, error_;             ///< of what is watched; of what was asked for last
    bool pending_ = true;                        ///< what is wished is still being loaded
    bool is_wished_ = false;                     ///< what is there is what is wished
    bool announce_ = true;                       ///< the state is to be said
    std::string save_kind_;                      ///< is to be saved when there is something to be seen
    std::deque<Plan> saves_;                     ///< not begun, or paused
    std::optional<std::array<double, 2>> place_; ///< to be looked at, asked for by place_input_
    std::uint64_t place_input_ = 0;
    std::atomic<std::uint64_t> serial_ = 1, drawn_serial_ = 0;
    std::uint64_t still_ = 0, rest_ = 0, traced_ = 0, input_ = 0;
    std::atomic<int> in_flight_ = 0, unsaved_ = 0;
    std::atomic<bool> closed_ = false;
    std::atomic<bool> has_things_ = false; ///< scene and environment, this request's or older ones
    Clock::time_point last_input_{};
    std::atomic<bool> moves_ = false; ///< an animation that takes time is playing
    std::optional<Clock::time_point>
        playing_; ///< since when the moment is that of the request; unset: not playing
};

} // namespace lambent::viewer
