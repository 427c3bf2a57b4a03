// Draws for all sessions, one picture at a time, each session in turn.
#pragma once

#include "apps/viewer/refinement.h"
#include "apps/viewer/session.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace lambent::viewer {

/// A thread that draws with all of TBB's. A long picture (a view at rest, a trace, a file) is abandoned when it is no
/// longer wanted, and pauses while other sessions' views move: it then gets at most a quarter of the time.
class DrawScheduler {
public:
    explicit DrawScheduler(AssetCache& assets);
    DrawScheduler(const DrawScheduler&) = delete;
    DrawScheduler& operator=(const DrawScheduler&) = delete;
    ~DrawScheduler();

    void add(std::shared_ptr<Session> session);

    /// Closes the session. A picture that is being drawn for it is abandoned.
    void remove(const std::shared_ptr<Session>& session);

    /// Ends all drawing; returns once nothing is shown any more.
    void stop();

    /// Lets the thread look for work after something changed. Any thread.
    void nudge();

    /// How long a long picture is drawn before it pauses for other sessions.
    static constexpr std::chrono::milliseconds slice{30};

private:
    /// A picture that is being drawn or paused.
    struct Begun {
        Plan plan;
        std::unique_ptr<draw::Drawing> drawing;
        double milliseconds = 0.0; ///< of drawing so far
    };
    using BegunPicture = std::unique_ptr<Begun>;

    /// A session and the state of its drawing; all but the session itself is used by the drawing thread alone.
    struct Client {
        std::shared_ptr<Session> session;
        BegunPicture paused;
        std::unique_ptr<Refinement> refinement; ///< of the last picture at rest; null: none
        double unseen_ms = 0.0;                 ///< of tracing since its last picture
        Clock::time_point moved{};              ///< when a picture that is not long was drawn last
        Clock::time_point long_after{}; ///< no long picture is drawn before this while other sessions move
    };
    using Clients = std::vector<std::shared_ptr<Client>>;

    Clients clients();
    static BegunPicture begin_or_resume(const Plan& plan, Client& client);
    template <class IsMoving>
    bool any_other(const Client& client, const IsMoving& is_moving);
    void work();
    bool work_once(Clock::time_point& wake);
    void carry_out(const Plan& plan, Client& client);
    void draw(const Plan& plan, Client& client);
    void refine(const Plan& plan, Client& client);
    void save(const Plan& plan, Client& client, draw::Frame frame);
    bool save_refined(const Plan& plan, Client& client);
    void trace(const Plan& plan, Client& client);
    void finish(const Plan& plan, Session& session, draw::Frame frame, double milliseconds) const;
    bool may_continue(const Plan& plan, const Client& client, Clock::time_point start);

    AssetCache& assets_;
    std::mutex mutex_;
    std::condition_variable wake_;
    Clients clients_;
    std::size_t next_ = 0;
    bool nudged_ = false;
    std::atomic<bool> ending_ = false;
    std::thread thread_; ///< last, as it uses the other members
};

} // namespace lambent::viewer
