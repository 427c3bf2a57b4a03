// One viewer: what it wants to see, and what is to be drawn next for it.
#pragma once

#include "apps/viewer/asset_cache.h"
#include "apps/viewer/draw_state.h"
#include "apps/viewer/pace.h"
#include "apps/viewer/plan.h"
#include "apps/viewer/shown_picture.h"
#include "apps/viewer/view_request.h"

#include <array>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace lambent::viewer {

/// The animations of the scene that is shown, and the one that is chosen.
struct Playing {
    std::vector<scene::AnimationInfo> animations; ///< the first 200
    int number = -1;          ///< of the chosen one, also beyond those 200; -1: none is chosen
    scene::AnimationInfo now; ///< the chosen one
    double moment = 0.0;      ///< seconds from its start
    bool on = false;
};

/// Inputs may come from any thread. Plans are asked for, and their results reported, by the drawing thread.
class Session {
public:
    static constexpr int most_in_flight = DrawState::most_in_flight;
    static constexpr int most_saves = 2;
    /// The view counts as at rest after so long without input.
    static constexpr std::chrono::milliseconds settle{60};
    /// A picture at rest is refined after so long: the first step cannot be left at once by a view that moves again.
    static constexpr std::chrono::milliseconds before_refining{250};
    /// The least time between two frames of an animation.
    static constexpr std::chrono::milliseconds least_step{16};

    Session(ViewRequest start, AssetCache& assets, std::shared_ptr<Presenter> presenter);

    using Change = std::function<void(ViewRequest&, const OrbitCamera::World&)>;

    /// Changes the request. Where `change` throws the request stays as it was, and the exception is passed on. `input`
    /// counts the viewer's inputs.
    void change(std::uint64_t input, const Change& change);

    /// Sets everything to its value at the start, except scene, environment and size.
    void reset(std::uint64_t input);

    /// Chooses an animation of the scene by its number from 0, at its start; below 0 none. Throws Error(usage) for
    /// other numbers. Does nothing before the scene is loaded.
    void animate(std::uint64_t input, double number);

    /// Goes to a moment of the animation in seconds, clamped to its duration.
    void seek(std::uint64_t input, double seconds);

    /// Plays the animation in a loop, the first one if none is chosen, or stops it.
    void play(std::uint64_t input, bool on);

    Playing playing() const;

    /// Shows another scene or environment as soon as it is loaded. If it cannot be loaded, state() says why.
    void open_scene(const std::string& name, std::uint64_t input = 0);
    void open_environment(const std::string& name, std::uint64_t input = 0);

    /// Whether a scene or an environment is being opened. Opening another one meanwhile replaces it.
    bool is_opening() const;

    /// Makes the surface point seen at (x, y) the middle of the picture; both from 0 to 1, from the top left.
    void focus(double x, double y, std::uint64_t input = 0);

    /// Saves the picture of the present request as "png" or "jpg", once its scene and environment are loaded. Throws
    /// Error(usage) for other kinds and while most_saves pictures are being saved.
    void save(const std::string& kind);

    /// Whether a picture is being saved: from save() until the presenter has it or state() says why it failed.
    bool is_saving() const { return draw_state_.unsaved() > 0; }

    /// The viewer saw a picture: another may be shown.
    void seen() { draw_state_.picture_left(); }

    /// Nothing more is drawn.
    void close() { draw_state_.close(); }

    /// The next picture to draw, if any; a long one only where `may_be_long`. If there is none, `wake` is brought
    /// forward to when to ask again, if that is known.
    std::optional<Plan> plan(Clock::time_point now, Clock::time_point& wake, bool may_be_long);

    /// The plan was drawn and shown, which took so long in all.
    void picture_finished(const Plan& plan, double milliseconds);

    /// The radiance drawn for a plan that is compared with the reference.
    void light_drawn(const Plan& plan, image::RadianceImage light);

    /// The picture that is shown now has had so many passes: state() has its command.
    void refined(const Plan& plan, int passes);

    /// The plan's picture is not refined further.
    void refinement_finished(const Plan& plan);

    /// The plan's reference reached its limits.
    void trace_finished(const Plan& plan);

    /// The plan was not drawn: `line` says why; it is empty if the picture was no longer wanted.
    void plan_failed(const Plan& plan, const std::string& line);

    /// The plan was begun and will be planned again.
    void plan_paused(const Plan& plan);

    /// The surface point that the plan looked for becomes the middle of the picture.
    void point_picked(const glm::dvec3& point, const Plan& plan);

    /// Sets the error in state(): one line.
    void report_error(const std::string& line);

    /// Whether the plan's picture is no longer wanted. Pictures to be saved always are.
    bool is_stale(const Plan& plan) const
    {
        return draw_state_.is_closed() ||
               (plan.task != Plan::Task::save && !draw_state_.is_current(plan.serial));
    }

    /// Whether a picture of a moving view can be drawn and is waited for.
    bool waits_for_moving_picture() const { return draw_state_.waits_for_moving_picture(); }

    Presenter& presenter() { return *presenter_; }

    /// The values of all controls, the command that draws the picture, and errors and warnings: JSON.
    std::string state() const;

    ViewRequest request() const;

    /// The request of the picture that is shown: one at rest gets more passes than were asked for.
    ViewRequest shown() const;
    double scale() const;

private:
    struct Opening {
        bool is_scene = false;
        std::string name; ///< empty: nothing is being opened
        std::uint64_t input = 0;
    };

    // All of these need mutex_ to be locked.
    void note_input(std::uint64_t input);
    void request_view();
    void open(Opening opening);
    void set_playing(const std::optional<Clock::time_point>& now);
    void advance_animation(Clock::time_point now, Clock::time_point& wake);
    void forget_lost_animation();
    double duration() const;
    OrbitCamera::World world() const;
    void set_error(const std::string& line);
    void finish_opening();
    bool find_assets();
    bool find_trace();
    bool is_compared() const;
    std::optional<Plan> next_plan(Clock::time_point now, Clock::time_point& wake, bool may_be_long);
    std::optional<Plan::Task> next_task(Clock::time_point now, Clock::time_point& wake, bool may_be_long);
    std::optional<Plan::Task> next_long_task(Clock::time_point now, Clock::time_point& wake);
    bool is_refined() const;
    Plan make_plan(Plan::Task task);
    void make_moving(Plan& plan);
    ViewRequest shown_request() const;
    void plan_requested_save();
    void plan_save();
    Playing playing_now() const;
    std::string state_now() const;

    AssetCache& assets_;
    const std::shared_ptr<Presenter> presenter_;
    const ViewRequest start_;
    DrawState draw_state_; ///< has a mutex of its own, the inner one: mutex_ may be held when it is locked

    mutable std::mutex mutex_; ///< guards everything below
    ViewRequest request_;
    std::uint64_t input_ = 0; ///< the last one that request_ contains
    Clock::time_point input_time_{};
    Pace pace_, light_pace_;        ///< of pictures without and with bounces of light
    Clock::time_point rest_time_{}; ///< of the last picture at rest
    int shown_passes_ = 0;          ///< of the picture at rest that is shown; 0: as asked for
    std::shared_ptr<Model> model_;  ///< of request_ or, until that is loaded, the one before
    std::shared_ptr<const cli::LoadedEnvironment> environment_; ///< likewise
    bool is_loading_ = true;     ///< the scene or the environment of request_ is being loaded
    bool is_loaded_ = false;     ///< model_ and environment_ are those of request_
    image::RadianceImage drawn_; ///< radiance at rest, to be compared; empty: not compared, or not drawn yet
    std::shared_ptr<Trace> trace_; ///< of the present request
    Opening opening_;
    std::optional<std::array<double, 2>> pick_place_; ///< as Plan::place; unset: nothing is to be looked for
    std::uint64_t pick_input_ = 0;                    ///< of the last focus()
    std::string save_kind_;                           ///< to be saved once loaded; empty: none
    std::deque<Plan> saves_;                          ///< not begun, or paused
    std::optional<Clock::time_point> playing_since_; ///< when request_.moment was current; unset: not playing
    std::string file_error_, error_;                 ///< of the files that are shown; of the last request
    bool has_news_ = true;                           ///< state() is to be sent to the presenter
};

} // namespace lambent::viewer
