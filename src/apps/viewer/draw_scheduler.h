// Draws for all sessions, one picture at a time, each session in its turn.
#pragma once

#include "apps/viewer/session.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace lambent::viewer {

/// One thread, which uses all others of TBB. A long picture (something at rest, a trace, a file) ends early when it is no
/// longer wanted, and pauses whenever something moves: of the time then at most a quarter is its.
class DrawScheduler {
public:
    explicit DrawScheduler(AssetCache& assets);
    DrawScheduler(const DrawScheduler&) = delete;
    DrawScheduler& operator=(const DrawScheduler&) = delete;
    ~DrawScheduler();

    void add(std::shared_ptr<Session> session);

    /// Closes it. What is being drawn for it ends soon.
    void remove(const std::shared_ptr<Session>& session);

    /// Ends the drawing for good; returns when nothing is shown any more.
    void stop();

    /// Something changed: there may be work. Any thread.
    void nudge();

    /// How long a long picture may go on while others wait.
    static constexpr std::chrono::milliseconds slice{30};

private:
    /// A picture that is being drawn, or pauses.
    struct Begun {
        Plan plan;
        std::unique_ptr<draw::Drawing> drawing;
        double milliseconds = 0.0; ///< that it took so far
    };
    using BegunPicture = std::unique_ptr<Begun>;

    /// All but the session is the drawing thread's.
    struct Place {
        std::shared_ptr<Session> session;
        BegunPicture paused;
        double unseen_ms = 0.0;        ///< of tracing, since the last picture of it
        Clock::time_point moved{};     ///< when something that moves was drawn last
        Clock::time_point long_from{}; ///< nothing long is drawn before, if others move
    };
    using Places = std::vector<std::shared_ptr<Place>>;

    Places places();
    static BegunPicture begin_or_go_on(const Plan& plan, Place& place);
    template <class IsMoving>
    bool any_moves(const Place& place, const IsMoving& is_moving);
    void work();
    bool work_once(Clock::time_point& wake);
    void carry_out(const Plan& plan, Place& place);
    void draw(const Plan& plan, Place& place);
    void trace(const Plan& plan, Place& place);
    void finish(const Plan& plan, Session& session, draw::Frame frame, double milliseconds) const;
    bool goes_on(const Plan& plan, const Place& place, Clock::time_point start);

    AssetCache& assets_;
    std::mutex mutex_;
    std::condition_variable wake_;
    Places places_;
    std::size_t next_ = 0;
    bool nudged_ = false;
    std::atomic<bool> ending_ = false;
    std::thread thread_; ///< last: it uses the others
};

} // namespace lambent::viewer
